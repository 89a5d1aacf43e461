#include "tools/commands/studies/study_commands.h"

#include <iostream>

#include <nlohmann/json.hpp>

#include "tools/json/document.h"
#include "tools/sequence_cache/sequence_cache.h"
#include "vo/files/result_files.h"

namespace tools {

void LaboratoryArguments::complete() {
  check_usage([&] { run.validate(); });
  run.trial.cache = cache_folder(cache);
}

void add_laboratory_options(CLI::App& command, LaboratoryArguments& arguments) {
  arguments.run.jobs = static_cast<int>(CommonOptions{}.max_threads());
  command.add_option("--out", arguments.out, "folder for all results")->required();
  command.add_option("--jobs,-j", arguments.run.jobs, "at a time [cores]");
  command.add_option("--cache", arguments.cache, "folder of the cache [$XDG_CACHE_HOME/edvo]");
  add_common_options(command, arguments.common);
}

void deliver_study(const StudyReport& report, const std::string& command, const std::string& folder,
                   const CommonOptions& common) {
  vo::write_results(folder, study_files(report, command), common.output_policy());
  print_study(report, common);
  if (!common.json) {
    const std::string stem = folder + "/" + report.name;
    std::cout << "\nreport   " << stem << ".md\nplot     " << stem << ".svg\ntable    " << stem
              << ".csv\n";
  }
}

void print_study(const StudyReport& report, const CommonOptions& common) {
  std::cout << (common.json ? json_text(json_document({"study"}, as_json(report)))
                            : as_text(report));
}

}  // namespace tools
