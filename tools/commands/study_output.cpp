#include "tools/commands/study_output.h"

#include <iostream>
#include <vector>

#include <nlohmann/json.hpp>

#include "vo/files/result_files.h"

namespace tools {

void deliver_study(const StudyReport& report, const std::string& command, const std::string& folder,
                   const CommonOptions& common) {
  std::vector<vo::NamedBytes> files = {{report.name + ".csv", as_csv(report.table)},
                                       {report.name + ".svg", report.plot},
                                       {report.name + ".md", as_markdown(report, command)}};
  files.insert(files.end(), report.more.begin(), report.more.end());
  vo::write_results(folder, files, common.existing());
  if (common.json) {
    std::cout << as_json(report).dump(2) << "\n";
    return;
  }
  const std::string stem = folder + "/" + report.name;
  std::cout << as_text(report) << "\nreport   " << stem << ".md\nplot     " << stem
            << ".svg\ntable    " << stem << ".csv\n";
}

}  // namespace tools
