#include "tools/datasets/merging/verify.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <system_error>

#include <tbb/parallel_for.h>

#include "tools/datasets/part_folder.h"
#include "tools/datasets/sha256.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/output_folders/file_records.h"
#include "vo/text_files/text_lines.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// Returns the checksums of a data set: the SHA-256 of each file and its name. Throws vo::Error
/// naming the line of what is no checksum of a file in the folder.
std::vector<std::pair<std::string, std::string>> read_checksums(const fs::path& folder) {
  constexpr std::size_t kDigits = 64;
  vo::require(path_exists(folder / kChecksums), folder.string(), ": holds no data set, expected ",
              kChecksums, " in it");
  std::vector<std::pair<std::string, std::string>> checksums;
  const vo::TextFile file(folder / kChecksums);
  file.for_each_whole_line([&](const vo::TextLine& line) {
    const std::string text(line.text);
    vo::require(text.size() > kDigits + 2 && text.compare(kDigits, 2, "  ") == 0, line.place(),
                ": expected a SHA-256, two blanks and a name");
    checksums.emplace_back(text.substr(0, kDigits), text.substr(kDigits + 2));
    vo::path_in(folder, checksums.back().second, line.place());
  });
  return checksums;
}

/// Counts what threads find, in the order of the files.
class Findings {
 public:
  Findings(std::size_t count, const vo::Progress& progress)
      : problems_(count), progress_(progress) {}

  /// Takes what was found of one of the things that are verified; empty = nothing.
  void add(std::size_t index, const std::string& problem, std::uintmax_t bytes) {
    const std::lock_guard lock(mutex_);
    problems_[index] = problem;
    bytes_ += bytes;
    ++done_;
    if (progress_) {
      progress_(done_, problems_.size());
    }
  }

  /// Moves what was found into a verification.
  void tell(Verification& verification) const {
    verification.bytes += bytes_;
    std::copy_if(problems_.begin(), problems_.end(), std::back_inserter(verification.problems),
                 [](const std::string& problem) { return !problem.empty(); });
  }

 private:
  std::vector<std::string> problems_;
  const vo::Progress& progress_;
  std::uintmax_t bytes_ = 0;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

std::uintmax_t size_of(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  return error ? 0 : size;
}

}  // namespace

std::string damage_of_file(const fs::path& file, const std::string& expected) {
  if (!path_exists(file)) {
    return "is missing";
  }
  return sha256_of_file(file) == expected ? "" : "is not as it was made: its SHA-256 differs";
}

Verification verify_dataset(const fs::path& folder, const vo::Progress& progress) {
  const auto checksums = read_checksums(folder);
  Verification verification{.files = checksums.size()};
  Findings findings(checksums.size(), progress);
  tbb::parallel_for(std::size_t{0}, checksums.size(), [&](std::size_t i) {
    const auto& [sum, name] = checksums[i];
    const std::string damage = damage_of_file(folder / name, sum);
    findings.add(i, damage.empty() ? "" : name + " " + damage, size_of(folder / name));
  });
  findings.tell(verification);
  std::set<std::string> known{kChecksums};
  for (const auto& [sum, name] : checksums) {
    known.insert(name);
  }
  for (const std::string& name : vo::files_below(folder)) {
    if (!known.contains(name)) {
      verification.problems.push_back(name + " is not of the data set");
    }
  }
  return verification;
}

}  // namespace tools
