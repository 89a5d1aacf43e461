#include "tools/commands/trial_arguments.h"

#include <iostream>

#include "tools/cli/exit_code.h"
#include "tools/cli/options.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Throws unless each bracket of an assignment that opens closes again.
void require_closed_brackets(const std::string& assignment) {
  int open = 0;
  for (const char c : assignment) {
    open += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (open < 0) {
      break;
    }
  }
  if (open != 0) {
    vo::fail_as(vo::ErrorKind::usage, "--set ", assignment, ": expected a ] for each [");
  }
}

/// Splits a list at commas outside of brackets; the brackets are removed from the values.
std::vector<std::string> split_values(const std::string& list) {
  std::vector<std::string> values(list.empty() ? 0 : 1);
  int open = 0;
  for (const char c : list) {
    if (c == '[' || c == ']') {
      open += c == '[' ? 1 : -1;
    } else if (c == ',' && open == 0) {
      values.emplace_back();
    } else {
      values.back() += c;
    }
  }
  return values;
}

}  // namespace

void ShareArguments::check() const {
  const auto expect = [](bool holds, const char* what) {
    if (!holds) {
      vo::fail_as(vo::ErrorKind::usage, what);
    }
  };
  expect(!runs_share() || !collects(), "--trials: expected no --collect with it");
  expect(runs_share() || shard.empty(), "--shard: expected --trials DIR with it");
  expect(runs_share() || collects() || shards == 0,
         "--shards: expected --trials DIR or --collect DIR with it");
}

void add_share_options(CLI::App& command, ShareArguments& arguments) {
  constexpr const char* kGroup = "Shares";
  command
      .add_option("--trials", arguments.trials, "write each trial into this folder, and no results")
      ->group(kGroup);
  command
      .add_option("--shard", arguments.shard, "K/N, only every N-th trial from the K-th, K from 1")
      ->group(kGroup);
  command
      .add_option("--shards", arguments.shards,
                  "--shard K/N with K from SLURM_ARRAY_TASK_ID, SGE_TASK_ID, PBS_ARRAY_INDEX")
      ->check(at_least_one())
      ->group(kGroup);
  command.add_option("--collect", arguments.collect, "take all trials from this folder")
      ->group(kGroup);
}

std::string share_name(const TaskShare& task) {
  return vo::concat("share ", task.task, "/", task.tasks);
}

std::string share_text(const TaskShare& task, const ShareOutcome& outcome) {
  return vo::concat(share_name(task), ": ", outcome.trials, " trials, of which ", outcome.kept,
                    " were there");
}

int print_share(const std::string& text, const ShareOutcome& outcome, const Session& session) {
  print_notes(outcome.unusable, session);
  print_notes(outcome.temporary, session);
  std::cout << text << "\n";
  return !outcome.temporary.empty()  ? exit_code::kTemporary
         : !outcome.unusable.empty() ? exit_code::kUnusableInput
                                     : exit_code::kOk;
}

int print_missing(const ShareArguments& arguments, const CollectedTrials& collected,
                  MissingShares where, const Session& session) {
  const std::size_t shares = arguments.shards > 0 ? arguments.shards : collected.expected;
  const std::string array = array_text(collected.missing_shares(shares));
  std::cerr << error_line(
      session.err, vo::concat(arguments.collect, ": ", collected.missing.size(), " of ",
                              collected.expected, " trials are missing, shares ", array, " of ",
                              shares, ": ", collected.names_of_missing()));
  if (where == MissingShares::also_on_stdout) {
    std::cout << array << "\n";
  }
  return exit_code::kMissing;
}

void print_notes(const std::vector<std::string>& notes, const Session& session) {
  for (const std::string& note : notes) {
    std::cerr << session.err.paint(Tone::caution, "edvo:") << " " << note << "\n";
  }
}

std::vector<std::pair<std::string, std::vector<std::string>>> swept_options(
    const std::vector<std::string>& assignments) {
  require_distinct_keys(assignments);
  std::vector<std::pair<std::string, std::vector<std::string>>> options;
  for (const std::string& assignment : assignments) {
    require_closed_brackets(assignment);
    const auto [key, list] = split_assignment(assignment);
    options.emplace_back(key, split_values(list));
    if (options.back().second.empty()) {
      vo::fail_as(vo::ErrorKind::usage, "--set ", assignment, ": expected key=value,value,...");
    }
  }
  return options;
}

}  // namespace tools
