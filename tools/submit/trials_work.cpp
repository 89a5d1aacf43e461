#include "tools/submit/trials_work.h"

#include <utility>

#include "tools/cli/exit_code.h"
#include "tools/submit/own_program.h"
#include "tools/submit/shares.h"

namespace tools {
namespace {

using Words = std::vector<std::string>;

const char* name_of(TrialsCommand command) {
  return command == TrialsCommand::test ? "test" : "sweep";
}

/// Returns `edvo COMMAND SCENARIOS... OPTIONS... OTHERS...`.
Words trial_words(const TrialsJob& job, const Words& others) {
  Words words{job.program.string(), name_of(job.command)};
  for (const std::filesystem::path& scenario : job.scenarios) {
    words.push_back(scenario.string());
  }
  words.insert(words.end(), job.options.begin(), job.options.end());
  words.insert(words.end(), others.begin(), others.end());
  return words;
}

/// Returns the options that write the results, after `before`.
Words with_results(Words before, const TrialsJob& job) {
  if (job.command == TrialsCommand::sweep) {
    before.insert(before.end(), {"--out", job.out.string()});
    if (job.force) {
      before.emplace_back("--force");
    }
    return before;
  }
  for (const auto& [option, file] : {std::pair{"--json", "results.json"},
                                     {"--junit", "junit.xml"},
                                     {"--report", "report.html"}}) {
    before.emplace_back(option);
    before.push_back((job.out / file).string());
  }
  return before;
}

Words collect_words(const TrialsJob& job, std::size_t shares) {
  return {"--quiet", "--collect", (job.out / "trials").string(), "--shards",
          std::to_string(shares)};
}

}  // namespace

SharedWork trials_work(const TrialsJob& job, std::size_t shares) {
  Words local;
  if (job.local_jobs > 0) {
    local = {"--jobs", std::to_string(job.local_jobs)};
  }
  return {.name = job.out.filename().string(),
          .folder = job.folder,
          .share_name = name_of(job.command),
          .share = trial_words(job, {"--quiet", "--jobs", std::to_string(job.task_jobs), "--trials",
                                     (job.out / "trials").string()}),
          .finish_name = "collect",
          .finish = trial_words(job, with_results(collect_words(job, shares), job)),
          .local = {trial_words(job, with_results(local, job))},
          .shares = shares};
}

std::vector<std::size_t> missing_shares(const TrialsJob& job, std::size_t shares,
                                        const vo::WaitObserver& waiting) {
  if (!std::filesystem::exists(job.out / "trials")) {
    return all_shares(shares);
  }
  const Printed printed = ask_program(
      {.words = trial_words(job, collect_words(job, shares)), .folder = job.folder},
      {exit_code::kOk, exit_code::kInternalError, exit_code::kBoundViolated, exit_code::kMissing},
      waiting);
  return printed.exit_code == exit_code::kMissing ? parse_shares(printed.out)
                                                  : std::vector<std::size_t>();
}

}  // namespace tools
