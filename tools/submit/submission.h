#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/submit/batch_script.h"
#include "tools/submit/shared_work.h"
#include "vo/files/output.h"

namespace tools {

/// What runs the shares.
enum class SubmitEngine {
  slurm,     ///< a cluster's queue
  parallel,  ///< GNU parallel on this machine, or on those that it is told of
  local      ///< this machine, as one process
};

constexpr auto enum_names(SubmitEngine) {
  return std::array{std::pair{SubmitEngine::slurm, "slurm"},
                    std::pair{SubmitEngine::parallel, "parallel"},
                    std::pair{SubmitEngine::local, "local"}};
}

/// A command that a submission runs in its folder, in their order.
struct SubmissionStep {
  std::string name;    ///< render-1, merge
  std::string shares;  ///< that it makes, in the syntax of --array; empty of the last
  std::vector<std::string> words;
  std::vector<std::size_t> after;  ///< steps that must have ended, however, before it may begin
};

/// What hands work to an engine: files, and commands that are run when the files are there.
struct Submission {
  SubmitEngine engine = SubmitEngine::slurm;
  std::filesystem::path folder;       ///< of the files; the commands of `local` run elsewhere
  std::vector<vo::NamedBytes> files;  ///< in the folder
  std::vector<std::string> folders;   ///< in the folder, for logs
  std::vector<SubmissionStep> steps;
};

/// Hands shares to Slurm: arrays below MaxArraySize, and a job after all of them, which runs
/// however they end. With a throttle one array begins when the one before it has ended, so that it
/// holds over all of them. The steps are calls of sbatch without the jobs they depend on.
Submission slurm_submission(const SharedWork& work, const std::vector<std::size_t>& shares,
                            const std::filesystem::path& folder, const BatchOptions& options);

/// Hands shares to GNU parallel, `jobs` at a time, 0 = as many as there are cores.
Submission parallel_submission(const SharedWork& work, const std::vector<std::size_t>& shares,
                               const std::filesystem::path& folder, int jobs);

/// Makes all of it on this machine, without shares and files.
Submission local_submission(const SharedWork& work);

/// Returns a submission as text: each file below a line with its name, and the commands as a shell
/// takes them.
std::string describe(const Submission& submission);

/// Returns the words of a step of Slurm that is to begin after jobs with these ids.
std::vector<std::string> words_after(const SubmissionStep& step,
                                     const std::vector<std::string>& ids);

}  // namespace tools
