#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tools {

/// A job that was submitted.
struct SubmittedJob {
  std::string id;      ///< as the queue names it
  std::string name;    ///< of its step: render-1, merge
  std::string shares;  ///< that it makes, as 1,3-5; empty of the last job
};

/// What was submitted last of some work: `jobs.json` in its folder, of the schema edvo.submission.
struct JobRecord {
  std::string work;        ///< a spec, or what is tested
  std::size_t shares = 1;  ///< in which the work is divided
  std::vector<SubmittedJob> jobs;
};

inline constexpr const char* kJobRecord = "jobs.json";

std::string format_job_record(const JobRecord& record);

/// Returns the record in a folder, nothing where there is none. Throws vo::Error naming the file
/// where it is none of that kind.
std::optional<JobRecord> read_job_record(const std::filesystem::path& folder);

}  // namespace tools
