#pragma once

#include <functional>
#include <string>

#include "tools/submit/job_record.h"
#include "tools/submit/slurm_queue.h"
#include "tools/submit/submission.h"
#include "vo/core/progress.h"

namespace tools {

/// Returns the folder of a submission's files and logs: beside what is made, `OUT.submit`.
std::filesystem::path submission_folder(const std::filesystem::path& out);

/// Throws vo::Error of kind output_exists, naming them, where jobs of a record are still queued.
void require_none_queued(const JobRecord& record, const SlurmQueue& queue);

/// Writes the files and submits the steps to Slurm. The record, whose jobs are what is submitted,
/// is kept in the folder after each step, so that it also has the jobs before one that failed.
void submit_to_slurm(const Submission& submission, const SlurmQueue& queue, JobRecord& record);

/// Throws vo::Error where the program of an engine that runs here is not installed.
void require_runnable(SubmitEngine engine);

/// Writes the files and runs the steps of another engine here, their output as this process' own;
/// returns the exit code of the last. A step of `local` that fails is the last. Requires
/// `require_runnable`. Throws vo::Error where a program cannot be started.
int run_here(const Submission& submission, const vo::WaitObserver& waiting);

}  // namespace tools
