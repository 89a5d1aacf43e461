#include "tools/laboratory/baseline.h"

#include "tools/json/document.h"
#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results_json.h"
#include "tools/processes/readable_text.h"
#include "vo/core/error.h"
#include "vo/files/output.h"

namespace tools {

std::vector<std::string> baseline_notes(const TestResults& baseline, const TestResults& results) {
  std::vector<std::string> notes;
  if (baseline.tracker != results.tracker) {
    notes.push_back(vo::concat("the baseline was measured with the tracker '",
                               readable_text(baseline.tracker), "', this is '",
                               readable_text(results.tracker), "'"));
  }
  for (const std::string& name : missing_scenarios(results, baseline)) {
    notes.push_back(name + ": the baseline does not have it; --save-baseline adds it");
  }
  return notes;
}

std::vector<std::string> save_baseline(const std::filesystem::path& file,
                                       const TestResults& results, const vo::OutputPolicy& policy) {
  TestResults measured = results;
  std::erase_if(measured.scenarios,
                [](const ScenarioResult& s) { return s.verdict() == Verdict::error; });
  const TestResults old = std::filesystem::exists(file) ? read_results(file) : TestResults();
  vo::write_file(file, json_text(results_json(updated(old, measured)), 1), policy);
  std::vector<std::string> notes;
  for (const std::string& name : missing_scenarios(results, measured)) {
    notes.push_back(vo::concat(name, ": was not measured and is not put into ", file.string()));
  }
  return notes;
}

}  // namespace tools
