#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include "tools/cli/interrupt.h"
#include "tools/cli/progress_bar.h"
#include "tools/colour/colour.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/output.h"

namespace tools {

inline constexpr double kBytesPerMegabyte = 1e6;

/// Options that every command takes.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  bool force = false;
  bool no_sync = false;
  int threads = 0;  ///< greatest number of threads; 0 = all cores

  std::size_t max_threads() const;
  tbb::global_control limit_threads() const;  ///< holds while the result lives
  Verbosity verbosity() const { return quiet ? Verbosity::quiet : Verbosity::normal; }
  vo::OutputPolicy output_policy() const {
    return {force ? vo::ExistingOutput::replace : vo::ExistingOutput::keep,
            no_sync ? vo::Durability::unsynced : vo::Durability::synced, throw_if_interrupted};
  }
};

void add_common_options(CLI::App& command, CommonOptions& options);

/// Adds the flag `--json` alone; `add_common_options` has it, too.
void add_json_flag(CLI::App& command, bool& json);

/// Adds the flag `--quiet` alone; `add_common_options` has it, too.
void add_quiet_flag(CLI::App& command, bool& quiet);

/// Adds the flag `--no-sync` alone; `add_common_options` has it, too.
void add_no_sync_flag(CLI::App& command, bool& no_sync);

/// Adds the option `--max-time-difference`, s: at least 0, between `what`.
void add_time_difference_option(CLI::App& command, double& seconds, const std::string& what);

/// Makes an empty value a usage error of every option of a program and its commands that takes one:
/// an option whose variable a script has not set would count as not given.
void refuse_empty_values(CLI::App& program);

/// Returns a check that an option's text is a whole number of at least 1.
CLI::Validator at_least_one();

/// Returns a check that an option's text is a whole number of 1 to `most`.
CLI::Validator from_one_to(std::int64_t most);

/// Returns the name of the option of a field by its key: `--time-limit` of `time_limit`.
std::string option_name(std::string key);

/// Adds an option `--key value` for each field ('_' as '-'), with its help and default.
void add_field_options(CLI::App& command, const std::vector<vo::Field>& fields,
                       const std::string& group);

/// Returns a check that an option's text is the name of one of an enumeration's values.
template <vo::NamedEnum E>
CLI::IsMember is_name_of() {
  const std::vector<std::string_view> names = vo::names_of<E>();
  return CLI::IsMember(std::vector<std::string>(names.begin(), names.end()));
}

/// Returns the two sides of `key=value`. Throws vo::Error of kind usage.
std::pair<std::string, std::string> split_assignment(const std::string& assignment);

/// Throws vo::Error of kind usage where one of the assignments has the key of another.
void require_distinct_keys(const std::vector<std::string>& assignments);

/// Returns the two sides of each `key=value`. Throws vo::Error of kind usage, also where a key is
/// there twice.
std::vector<std::pair<std::string, std::string>> split_assignments(
    const std::vector<std::string>& assignments);

/// Returns the options that give the assignments: ` --set key=value` for each.
std::string format_assignments(const std::vector<std::string>& assignments);

/// Applies `key=value` to the fields; a note on stderr, in these colours, says where the key has a
/// new name. Throws vo::Error of kind usage.
void apply_assignment(const std::string& assignment, std::vector<vo::Field>& fields,
                      const Colours& colours);

/// Returns all fields with default and meaning, one per line, for the end of `--help`.
std::string describe_fields(const std::vector<vo::Field>& fields);

/// Calls `check` and rethrows its vo::Error as kind usage, for values that came from the command
/// line.
template <typename Check>
void check_usage(Check check) {
  try {
    check();
  } catch (const vo::Error& error) {
    throw vo::Error(error.what(), vo::ErrorKind::usage);
  }
}

/// Parses a size such as "640x480". Throws vo::Error of kind usage.
std::pair<int, int> parse_size(const std::string& text);

}  // namespace tools
