#include "tools/submit/submission.h"

#include <algorithm>
#include <numeric>

#include "tools/cli/task_share.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns `sbatch --parsable OTHERS... NAME.sbatch`.
std::vector<std::string> sbatch_words(const BatchOptions& options, const std::string& name) {
  std::vector<std::string> words{"sbatch", "--parsable"};
  words.insert(words.end(), options.others.begin(), options.others.end());
  words.push_back(name + ".sbatch");
  return words;
}

/// Returns the name of a shell's variable that holds the id of a step's job.
std::string variable_of(const SubmissionStep& step) {
  std::string name = step.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Returns a call of sbatch as a shell takes it, the ids it depends on from variables.
std::string sbatch_line(const SubmissionStep& step, const std::vector<std::string>& variables) {
  std::string line;
  for (const std::string& word : words_after(step, variables)) {
    const bool has_variable = !variables.empty() && word.starts_with("--dependency=afterany:$");
    line += (line.empty() ? "" : " ") + (has_variable ? word : shell_line({word}));
  }
  return line;
}

}  // namespace

Submission slurm_submission(const SharedWork& work, const std::vector<std::size_t>& shares,
                            const std::filesystem::path& folder, const BatchOptions& options) {
  Submission submission{.engine = SubmitEngine::slurm, .folder = folder};
  for (const ArrayChunk& chunk : chunk_shares(shares, options.max_array)) {
    const std::size_t number = submission.steps.size();
    const std::string name = vo::concat(work.share_name, "-", number + 1);
    submission.files.push_back({name + ".sbatch", array_script(work, chunk, name, options)});
    submission.folders.push_back("log/" + name);
    submission.steps.push_back(
        {.name = name, .shares = array_text(chunk.shares()), .words = sbatch_words(options, name)});
    if (options.throttle > 0 && number > 0) {
      submission.steps.back().after = {number - 1};
    }
  }
  SubmissionStep finish{.name = work.finish_name, .words = sbatch_words(options, work.finish_name)};
  finish.after.resize(submission.steps.size());
  std::iota(finish.after.begin(), finish.after.end(), std::size_t{0});
  submission.files.push_back({finish.name + ".sbatch", finish_script(work, options)});
  submission.folders.emplace_back("log");
  submission.steps.push_back(finish);
  return submission;
}

Submission parallel_submission(const SharedWork& work, const std::vector<std::size_t>& shares,
                               const std::filesystem::path& folder, int jobs) {
  const std::string place = "cd -- " + shell_line({work.folder.string()}) + " || exit 3\nexec ";
  std::string lines;
  for (const std::size_t share : shares) {
    lines += std::to_string(share) + "\n";
  }
  Submission submission{.engine = SubmitEngine::parallel, .folder = folder};
  submission.files = {
      {"share.sh", vo::concat("#!/bin/sh\n# share.sh K makes the K-th share.\n", place,
                              shell_line(work.share), " --shard \"$1/", work.shares, "\"\n")},
      {"shares.txt", lines},
      {work.finish_name + ".sh", "#!/bin/sh\n" + place + shell_line(work.finish) + "\n"}};
  if (!shares.empty()) {
    submission.steps.push_back(
        {.name = work.share_name,
         .shares = array_text(shares),
         .words = {"parallel", "--quote", "--jobs", jobs == 0 ? "100%" : std::to_string(jobs),
                   "--joblog", "joblog", "--arg-file", "shares.txt", "sh",
                   (folder / "share.sh").string(), "{}"}});
  }
  submission.steps.push_back({.name = work.finish_name, .words = {"sh", work.finish_name + ".sh"}});
  return submission;
}

Submission local_submission(const SharedWork& work) {
  Submission submission{.engine = SubmitEngine::local, .folder = work.folder};
  for (const std::vector<std::string>& words : work.local) {
    submission.steps.push_back({.name = work.name, .words = words});
  }
  return submission;
}

std::vector<std::string> words_after(const SubmissionStep& step,
                                     const std::vector<std::string>& ids) {
  std::vector<std::string> words = step.words;
  if (!ids.empty()) {
    std::string dependency = "--dependency=afterany";
    for (const std::string& id : ids) {
      dependency += ":" + id;
    }
    words.insert(words.begin() + 2, {dependency, "--kill-on-invalid-dep=yes"});
  }
  return words;
}

std::string describe(const Submission& submission) {
  std::string text;
  for (const vo::NamedBytes& file : submission.files) {
    text += "# " + (submission.folder / file.name).string() + "\n" + file.bytes + "\n";
  }
  text += "# commands\n" + shell_line({"cd", submission.folder.string()}) + "\n";
  for (const SubmissionStep& step : submission.steps) {
    std::vector<std::string> variables;
    for (const std::size_t earlier : step.after) {
      variables.push_back("$" + variable_of(submission.steps[earlier]));
    }
    text += submission.engine == SubmitEngine::slurm
                ? variable_of(step) + "=$(" + sbatch_line(step, variables) + ")\n"
                : shell_line(step.words) + "\n";
  }
  return text;
}

}  // namespace tools
