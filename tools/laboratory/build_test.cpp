#include "tools/laboratory/build_test.h"

#include "tools/laboratory/results_json.h"
#include "tools/processes/child_process.h"
#include "tools/processes/scratch_folder.h"
#include "vo/core/error.h"

namespace tools {

TestResults test_build(const std::filesystem::path& build,
                       const std::vector<std::string>& scenarios, int seeds,
                       const vo::WaitObserver& waiting) {
  constexpr double kTimeLimit = 24 * 3600;  // time limit, s
  const ScratchFolder scratch;
  const std::filesystem::path results = scratch.path() / "results.json";
  ChildCommand command{.words = {std::filesystem::absolute(build).string(), "test", "--quiet",
                                 "--json", results.string(), "--seeds", std::to_string(seeds)}};
  command.words.insert(command.words.end(), scenarios.begin(), scenarios.end());
  run_child(command, {.time = kTimeLimit}, waiting);
  vo::require(std::filesystem::exists(results), build.string(),
              ": left no results of `edvo test`, expected a build of edvo that has it");
  return read_results(results);
}

}  // namespace tools
