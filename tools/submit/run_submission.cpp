#include "tools/submit/run_submission.h"

#include <filesystem>
#include <system_error>
#include <vector>

#include "tools/processes/foreground.h"
#include "tools/processes/printed.h"
#include "vo/core/error.h"
#include "vo/files/output.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

void write_submission(const Submission& submission) {
  for (const std::string& folder : submission.folders) {
    std::error_code error;
    fs::create_directories(submission.folder / folder, error);
    if (error) {
      vo::fail_with(submission.folder / folder, "cannot be made", error.value());
    }
  }
  vo::write_files(submission.folder, submission.files, vo::ExistingOutput::replace);
}

}  // namespace

fs::path submission_folder(const fs::path& out) {
  return vo::resolved_output(out).string() + ".submit";
}

void require_none_queued(const JobRecord& record, const SlurmQueue& queue) {
  std::string queued;
  for (const SubmittedJob& job : record.jobs) {
    if (queue.is_queued(job.id)) {
      queued += (queued.empty() ? "" : ", ") + job.id + " (" + job.name + ")";
    }
  }
  if (!queued.empty()) {
    vo::fail_as(vo::ErrorKind::output_exists, record.work,
                ": is submitted already, and these jobs are queued or running: ", queued,
                "; expected none (scancel ends them)");
  }
}

void submit_to_slurm(const Submission& submission, const SlurmQueue& queue, JobRecord& record) {
  write_submission(submission);
  record.jobs.clear();
  for (const SubmissionStep& step : submission.steps) {
    std::vector<std::string> ids;
    for (const std::size_t earlier : step.after) {
      ids.push_back(record.jobs[earlier].id);
    }
    const std::string id = queue.submit(words_after(step, ids), submission.folder);
    record.jobs.push_back({.id = id, .name = step.name, .shares = step.shares});
    vo::write_file(submission.folder / kJobRecord, format_job_record(record),
                   vo::ExistingOutput::replace);
  }
}

void require_runnable(SubmitEngine engine) {
  vo::require(engine != SubmitEngine::parallel || is_in_path("parallel"),
              "parallel is not in PATH: expected GNU parallel (Debian's package parallel), or "
              "--engine local");
}

int run_here(const Submission& submission, const vo::WaitObserver& waiting) {
  write_submission(submission);
  int code = 0;
  for (const SubmissionStep& step : submission.steps) {
    code = run_in_foreground({.words = step.words, .folder = submission.folder}, waiting);
    if (code != 0 && submission.engine == SubmitEngine::local) {
      break;
    }
  }
  return code;
}

}  // namespace tools
