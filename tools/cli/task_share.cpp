#include "tools/cli/task_share.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>

#include "synth/sequence/frame_share.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

/// A TaskVariable is a variable by which a queue tells a process which task of an array it is.
struct TaskVariable {
  const char* name;
  int first;  ///< number of an array's first task
};

constexpr std::array kTaskVariables{
    TaskVariable{"SLURM_ARRAY_TASK_ID", 1}, TaskVariable{"SGE_TASK_ID", 1},
    TaskVariable{"PBS_ARRAY_INDEX", 1}, TaskVariable{"JOB_COMPLETION_INDEX", 0}};

/// Returns a variable's value; empty where it is not set or, as Grid Engine says it of what is no
/// array, undefined.
std::string value_of(const char* name, const Environment& environment) {
  const char* value = environment(name);
  const std::string text = value == nullptr ? "" : value;
  return text == "undefined" ? "" : text;
}

/// Throws where an array has a task 0: only that one could see that its number is wrong, and the
/// last share would be missing.
void require_counted_from_one(std::size_t shards, const Environment& environment) {
  constexpr const char* kLeast = "SLURM_ARRAY_TASK_MIN";
  if (value_of(kLeast, environment) == "0") {
    vo::fail_as(vo::ErrorKind::usage, "--shards ", shards, ": ", kLeast,
                " is 0, expected an array that counts from 1, --array=1-", shards);
  }
}

/// Returns the number of a share from 1 that a variable's value says; empty if it says none.
std::optional<std::size_t> parse_task(const TaskVariable& variable, const std::string& text,
                                      std::size_t shards) {
  try {
    const std::int64_t number = vo::parse_integer(text);
    if (number >= variable.first && std::cmp_less(number - variable.first, shards)) {
      return static_cast<std::size_t>(number - variable.first) + 1;
    }
    return {};
  } catch (const vo::Error&) {
    return {};
  }
}

TaskShare share_of_array(std::size_t shards, const Environment& environment) {
  require_counted_from_one(shards, environment);
  for (const TaskVariable& variable : kTaskVariables) {
    const std::string text = value_of(variable.name, environment);
    if (text.empty()) {
      continue;
    }
    if (const std::optional<std::size_t> task = parse_task(variable, text, shards)) {
      return {*task, shards};
    }
    vo::fail_as(vo::ErrorKind::usage, "--shards ", shards, ": ", variable.name, " is '", text,
                "', expected ", variable.first, " to ",
                shards + static_cast<std::size_t>(variable.first) - 1);
  }
  vo::fail_as(vo::ErrorKind::usage, "--shards ", shards,
              ": expected a task of an array (SLURM_ARRAY_TASK_ID is not set), or --shard K/",
              shards);
}

}  // namespace

const char* environment_variable(const char* name) {
  return std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing sets variables
}

TaskShare chosen_share(const std::string& shard, std::size_t shards,
                       const Environment& environment) {
  if (!shard.empty() && shards > 0) {
    vo::fail_as(vo::ErrorKind::usage, "--shards: expected no --shard K/N with it");
  }
  if (!shard.empty()) {
    synth::FrameShare share;
    synth::parse_shard(shard, share);
    return {share.shard, share.shards};
  }
  return shards > 0 ? share_of_array(shards, environment) : TaskShare();
}

std::string array_text(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) {
      ++end;
    }
    text += vo::concat(text.empty() ? "" : ",", numbers[i]);
    if (end > i + 1) {
      text += vo::concat("-", numbers[end - 1]);
    }
    i = end;
  }
  return text;
}

}  // namespace tools
