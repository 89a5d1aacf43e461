#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/cli/session.h"
#include "tools/cli/task_share.h"
#include "tools/trials/trial_share.h"

namespace tools {

/// Arguments of commands whose trials may be run by many tasks: --trials runs some of them and
/// --collect takes all; without both one process runs all.
struct ShareArguments {
  std::string shard;       ///< K/N
  std::size_t shards = 0;  ///< 0 = not given
  std::string trials;      ///< folder that a share's trials are written into
  std::string collect;     ///< folder that all trials are read from

  bool runs_share() const { return !trials.empty(); }
  bool collects() const { return !collect.empty(); }

  /// Throws vo::Error of kind usage for options that contradict each other.
  void check() const;
};

void add_share_options(CLI::App& command, ShareArguments& arguments);

/// Returns a share's name, as "share 2/12".
std::string share_name(const TaskShare& task);

/// Returns what has become of a share, as a sentence without its end.
std::string share_text(const TaskShare& task, const ShareOutcome& outcome);

/// Prints what has become of a share, and of its trials that were not measured; returns the exit
/// code.
int print_share(const std::string& text, const ShareOutcome& outcome, const Session& session);

/// Where the numbers of the missing shares are printed.
enum class MissingShares { with_message, also_on_stdout };

/// Says which trials are missing and which shares to run for them; returns the exit code. Where
/// nobody says how many shares there are, each trial is one.
int print_missing(const ShareArguments& arguments, const CollectedTrials& collected,
                  MissingShares where, const Session& session);

/// Prints notes on stderr, a line each.
void print_notes(const std::vector<std::string>& notes, const Session& session);

/// Returns the options and their values of assignments such as `key=a,b,c`; commas in brackets
/// belong to a value. Throws vo::Error of kind usage for an assignment without a value, a bracket
/// that is not closed and a key that is there twice.
std::vector<std::pair<std::string, std::vector<std::string>>> swept_options(
    const std::vector<std::string>& assignments);

}  // namespace tools
