#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"
#include "tools/submit/shared_work.h"
#include "vo/files/input.h"

namespace support {

/// Programs in a folder of their own that is first in PATH while the object lives. Each writes the
/// words that it was given into a file NAME.log, a line for each call, `|` after each word.
class StandIns {
 public:
  StandIns() {
    const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): one thread
    old_path_ = path == nullptr ? "" : path;
    set_path(folder_.path().string() + ":" + old_path_);
  }
  ~StandIns() { set_path(old_path_); }
  StandIns(const StandIns&) = delete;
  StandIns& operator=(const StandIns&) = delete;
  StandIns(StandIns&&) = delete;
  StandIns& operator=(StandIns&&) = delete;

  /// Makes a program, a script of sh that records its words and goes on with `script`.
  std::filesystem::path add(const std::string& name, const std::string& script) const {
    const std::filesystem::path file = folder_.write(
        name, "#!/bin/sh\nhere=$(dirname \"$0\")\n{ printf '%s|' \"$@\"; echo; } >> \"$0.log\"\n" +
                  script + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }

  /// Returns what a program was given; empty where it was not called.
  std::string calls(const std::string& name) const {
    const std::filesystem::path log = folder_.path() / (name + ".log");
    return std::filesystem::exists(log) ? vo::read_file(log) : "";
  }

  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    return folder_.write(name, bytes);
  }

  /// Slurm's programs: sbatch gives the numbers 41, 42, ...; the jobs in the file `queued`, one a
  /// line, are queued; MaxArraySize is 5.
  void add_slurm() const {
    add("sbatch", "n=$(wc -l < \"$0.log\"); echo $((40 + n))");
    add("squeue",
        "test -e \"$here/queued\" || { echo 'slurm_load_jobs error: Invalid job id specified' "
        ">&2; exit 1; }\ngrep -x \"$3\" \"$here/queued\" || true");
    add("scontrol", "echo 'MaxArraySize            = 5'; echo 'MaxJobCount = 10000'");
  }

 private:
  static void set_path(const std::string& path) {
    setenv("PATH", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
  }

  TempFolder folder_;
  std::string old_path_;
};

/// StandIns with Slurm's programs from the start.
class SlurmStandIns : public StandIns {
 public:
  SlurmStandIns() { add_slurm(); }
};

/// Names that a shell could take for something else.
inline std::vector<std::string> odd_names() {
  return {"it's", "a b",  "$HOME",   "`id`",        "\"q\"", "a;b&c|d", "*",
          "-n",   "x\ny", "#SBATCH", "back\\slash", "%a",    "~"};
}

/// Work whose program is `program`, with words that need quotes.
inline tools::SharedWork odd_work(const std::filesystem::path& program,
                                  const std::filesystem::path& folder) {
  std::vector<std::string> words{program.string()};
  for (const std::string& name : odd_names()) {
    words.push_back(name);
  }
  return {.name = "it's\n#SBATCH --hold",
          .folder = folder,
          .share_name = "render",
          .share = words,
          .finish_name = "merge",
          .finish = words,
          .local = {words},
          .shares = 12};
}

}  // namespace support
