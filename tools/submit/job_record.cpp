#include "tools/submit/job_record.h"

#include <nlohmann/json.hpp>

#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/text_files/json_limits.h"

namespace tools {

std::string format_job_record(const JobRecord& record) {
  nlohmann::ordered_json jobs = nlohmann::ordered_json::array();
  for (const SubmittedJob& job : record.jobs) {
    jobs.push_back({{"id", job.id}, {"name", job.name}, {"shares", job.shares}});
  }
  return json_text(json_document(
      {"submission"}, {{"work", record.work}, {"shares", record.shares}, {"jobs", jobs}}));
}

std::optional<JobRecord> read_job_record(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kJobRecord;
  if (!std::filesystem::exists(file)) {
    return {};
  }
  const std::string text = vo::read_file(file, vo::kMaxDocumentBytes);
  vo::require_json_within_limits(text, file.string());
  try {
    const nlohmann::json document = nlohmann::json::parse(text);
    JobRecord record{.work = document.at("work"), .shares = document.at("shares")};
    for (const nlohmann::json& job : document.at("jobs")) {
      record.jobs.push_back(
          {.id = job.at("id"), .name = job.at("name"), .shares = job.at("shares")});
    }
    vo::require(record.shares > 0, file.string(), ": shares is ", record.shares,
                ", expected at least 1");
    return record;
  } catch (const nlohmann::json::exception& error) {
    vo::fail(file.string(), ": is no record of submitted jobs: ", error.what());
  }
}

}  // namespace tools
