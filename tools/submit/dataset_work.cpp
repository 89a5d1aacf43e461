#include "tools/submit/dataset_work.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tools/cli/exit_code.h"
#include "tools/submit/own_program.h"
#include "tools/submit/shares.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns `edvo dataset ACTION SPEC --out OUT OTHERS...`.
std::vector<std::string> dataset_words(const DatasetJob& job, const std::string& action,
                                       const std::vector<std::string>& others) {
  std::vector<std::string> words{job.program.string(), "dataset", action,
                                 job.spec.string(),    "--out",   job.out.string()};
  words.insert(words.end(), others.begin(), others.end());
  return words;
}

}  // namespace

SharedWork dataset_work(const DatasetJob& job, std::size_t shares) {
  const std::vector<std::string> threads{"--quiet", "--threads", std::to_string(job.task_threads)};
  const std::string local_threads = std::to_string(job.local_threads);
  return {.name = job.spec.stem().string(),
          .folder = job.spec.parent_path(),
          .share_name = "render",
          .share = dataset_words(job, "render", threads),
          .finish_name = "merge",
          .finish = dataset_words(job, "merge", threads),
          .local = {dataset_words(job, "render", {"--threads", local_threads}),
                    dataset_words(job, "merge", {"--threads", local_threads})},
          .shares = shares};
}

DatasetSize plan_dataset(const DatasetJob& job, KeepPlan keep, const vo::WaitObserver& waiting) {
  std::vector<std::string> words = dataset_words(job, "plan", {"--json", "--quiet"});
  if (keep == KeepPlan::no) {
    const auto out = std::find(words.begin(), words.end(), "--out");
    words.erase(out, out + 2);
  }
  const Printed plan = ask_program({.words = words}, {exit_code::kOk}, waiting);
  const DatasetSize size{.parts = printed_member(plan, "parts"),
                         .processor_s = printed_member(plan, "cpu_s")};
  vo::require(size.parts > 0, job.spec.string(), ": has no part to render, expected a sequence");
  return size;
}

std::size_t shares_for(const DatasetSize& size, int task_threads) {
  constexpr double kSecondsOfShare = 600;
  const double shares = std::ceil(size.processor_s / task_threads / kSecondsOfShare);
  return static_cast<std::size_t>(std::clamp(shares, 1.0, static_cast<double>(size.parts)));
}

std::vector<std::size_t> missing_shares(const DatasetJob& job, std::size_t shares,
                                        const vo::WaitObserver& waiting) {
  const std::vector<std::string> words =
      dataset_words(job, "status", {"--shards", std::to_string(shares), "--json", "--quiet"});
  const Printed printed =
      ask_program({.words = words}, {exit_code::kOk, exit_code::kMissing}, waiting);
  return parse_shares(printed_member(printed, "missing_shards").get<std::string>());
}

}  // namespace tools
