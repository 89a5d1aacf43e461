#include "tools/commands/laboratory.h"

#include <filesystem>

#include "tools/sequence_cache/sequence_cache.h"

namespace tools {

Assignments LaboratoryArguments::changes() const {
  Assignments changes;
  for (const std::string& assignment : assignments) {
    changes.push_back(split_assignment(assignment));
  }
  return changes;
}

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

}  // namespace tools
