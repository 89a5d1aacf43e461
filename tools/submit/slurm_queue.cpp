#include "tools/submit/slurm_queue.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

#include "tools/processes/printed.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::string_view kDigits = "0123456789";

/// Returns what a program says of its failure, without blanks around it.
std::string reason_of(const Printed& printed) {
  const std::size_t last = printed.err.find_last_not_of(" \t\r\n");
  return last == std::string::npos ? vo::concat("exit code ", printed.exit_code)
                                   : printed.err.substr(0, last + 1);
}

[[noreturn]] void fail_as_queue(const char* program, const Printed& printed) {
  vo::fail_as(vo::ErrorKind::temporary, program, ": ", reason_of(printed));
}

}  // namespace

SlurmQueue::SlurmQueue(vo::WaitObserver waiting) : waiting_(std::move(waiting)) {
  vo::require(is_in_path("sbatch"),
              "sbatch is not in PATH: expected Slurm's programs (Debian's package slurm-client), "
              "or --engine local");
}

std::size_t SlurmQueue::max_array_size() const {
  const Printed printed = run_and_read({.words = {"scontrol", "show", "config"}}, waiting_);
  if (printed.exit_code != 0) {
    fail_as_queue("scontrol show config", printed);
  }
  const std::size_t key = printed.out.find("MaxArraySize");
  const std::size_t digits =
      key == std::string::npos ? key : printed.out.find_first_of(kDigits, key);
  std::size_t size = 0;
  vo::require(
      digits != std::string::npos &&
          std::from_chars(&printed.out[digits], printed.out.data() + printed.out.size(), size).ec ==
              std::errc(),
      "scontrol show config: has no MaxArraySize, expected --max-array N");
  return size;
}

bool SlurmQueue::is_queued(const std::string& id) const {
  const Printed printed = run_and_read({.words = {"squeue", "-h", "-j", id}}, waiting_);
  if (printed.exit_code != 0 && printed.err.find("Invalid job id") != std::string::npos) {
    return false;
  }
  if (printed.exit_code != 0) {
    fail_as_queue("squeue", printed);
  }
  return std::any_of(printed.out.begin(), printed.out.end(),
                     [](unsigned char c) { return std::isspace(c) == 0; });
}

std::string SlurmQueue::submit(const std::vector<std::string>& words,
                               const std::filesystem::path& folder) const {
  waiting_();
  // Not interrupted: a job whose number is not read would be in the queue without anybody's
  // knowing.
  const Printed printed = run_and_read({.words = words, .folder = folder}, [] {});
  vo::require(printed.exit_code == 0, "sbatch ", words.back(), ": ", reason_of(printed));
  // ID, or ID;CLUSTER
  std::string id = printed.out.substr(0, printed.out.find_first_not_of(kDigits));
  vo::require(!id.empty(), "sbatch ", words.back(), ": printed \"", printed.out,
              "\", expected the number of a job");
  return id;
}

}  // namespace tools
