#include "tools/cli/options.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <set>
#include <utility>

#include <tbb/info.h>

#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns the function of a check that an option's text is a whole number of 1 to `most`; it
/// returns a complaint, or nothing.
std::function<std::string(std::string&)> check_of_count(std::int64_t most,
                                                        const std::string& expected) {
  return [most, expected](const std::string& text) -> std::string {
    try {
      const std::int64_t number = vo::parse_integer(text);
      vo::require(number >= 1 && number <= most, "out of range");
      return "";
    } catch (const vo::Error&) {
      return vo::concat("expected ", expected, ", got ", text);
    }
  };
}

}  // namespace

std::string option_name(std::string key) {
  std::replace(key.begin(), key.end(), '_', '-');
  return "--" + key;
}

std::size_t CommonOptions::max_threads() const {
  return static_cast<std::size_t>(threads > 0 ? threads : tbb::info::default_concurrency());
}

tbb::global_control CommonOptions::limit_threads() const {
  return {tbb::global_control::max_allowed_parallelism, max_threads()};
}

void add_json_flag(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print the result as JSON on stdout; --json - is the same");
}

void add_quiet_flag(CLI::App& command, bool& quiet) {
  command.add_flag("--quiet,-q", quiet, "no progress on stderr");
}

void add_no_sync_flag(CLI::App& command, bool& no_sync) {
  command.add_flag("--no-sync", no_sync,
                   "do not wait until outputs are on the disk: faster, lost with the power");
}

void add_common_options(CLI::App& command, CommonOptions& options) {
  add_json_flag(command, options.json);
  add_quiet_flag(command, options.quiet);
  command.add_flag("--force", options.force,
                   "replace an output that exists and differs; files of others are kept");
  add_no_sync_flag(command, options.no_sync);
  command.add_option("--threads", options.threads, "threads at most; 0 = all cores")
      ->check(CLI::NonNegativeNumber);
}

void add_time_difference_option(CLI::App& command, double& seconds, const std::string& what) {
  command.add_option("--max-time-difference", seconds, "between " + what + ", s [0.02]")
      ->check([](const std::string& text) -> std::string {
        try {
          const double value = vo::parse_real(text);
          vo::require(std::isfinite(value) && value >= 0, "out of range");
          return "";
        } catch (const vo::Error&) {
          return vo::concat("expected at least 0 s, got ", text);
        }
      });
}

void refuse_empty_values(CLI::App& program) {
  for (CLI::Option* option : program.get_options()) {
    if (option->get_items_expected_min() > 0) {
      option->check([](const std::string& text) {
        return std::string(text.empty() ? "is empty, expected a value or no such option" : "");
      });
    }
  }
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    refuse_empty_values(*command);
  }
}

CLI::Validator at_least_one() {
  return {check_of_count(std::numeric_limits<std::int64_t>::max(), "at least 1"), "POSITIVE",
          "at_least_one"};
}

CLI::Validator from_one_to(std::int64_t most) {
  const std::string expected = vo::concat("1 to ", most);
  return {check_of_count(most, expected), expected, "from_one_to"};
}

void add_field_options(CLI::App& command, const std::vector<vo::Field>& fields,
                       const std::string& group) {
  for (const vo::Field& field : fields) {
    const std::string name = option_name(field.key);
    const std::string value = field.get();
    command
        .add_option_function<std::string>(
            name,
            [set = field.set, name](const std::string& text) {
              try {
                set(text);
              } catch (const vo::Error& error) {
                throw CLI::ValidationError(name, error.what());
              }
            },
            field.help + (value.empty() ? "" : " [" + value + "]"))
        ->group(group);
  }
}

std::pair<std::string, std::string> split_assignment(const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) {
    vo::fail_as(vo::ErrorKind::usage, "--set ", assignment, ": expected key=value");
  }
  return {assignment.substr(0, equals), assignment.substr(equals + 1)};
}

void require_distinct_keys(const std::vector<std::string>& assignments) {
  std::set<std::string> keys;
  for (const std::string& assignment : assignments) {
    const std::string key = vo::current_key(split_assignment(assignment).first);
    if (!keys.insert(key).second) {
      vo::fail_as(vo::ErrorKind::usage, "--set ", assignment, ": ", key,
                  " is set twice, expected each key once");
    }
  }
}

std::vector<std::pair<std::string, std::string>> split_assignments(
    const std::vector<std::string>& assignments) {
  require_distinct_keys(assignments);
  std::vector<std::pair<std::string, std::string>> split(assignments.size());
  std::transform(assignments.begin(), assignments.end(), split.begin(), split_assignment);
  return split;
}

std::string format_assignments(const std::vector<std::string>& assignments) {
  std::string text;
  for (const std::string& assignment : assignments) {
    text += " --set " + assignment;
  }
  return text;
}

void apply_assignment(const std::string& assignment, std::vector<vo::Field>& fields,
                      const Colours& colours) {
  const auto [key, value] = split_assignment(assignment);
  if (const std::string current = vo::current_key(key); current != key) {
    std::cerr << "edvo: " << colours.paint(Tone::caution, "note") << ": " << key << " is "
              << current << " now\n";
  }
  try {
    vo::set_field(fields, key, value);
  } catch (const vo::Error& error) {
    vo::fail_as(vo::ErrorKind::usage, "--set ", assignment, ": ", error.what());
  }
}

std::string describe_fields(const std::vector<vo::Field>& fields) {
  std::size_t width = 0;
  for (const vo::Field& field : fields) {
    width = std::max(width, field.key.size() + field.get().size() + 3);
  }
  std::string text;
  for (const vo::Field& field : fields) {
    std::string assignment = field.key + " = " + field.get();
    assignment.resize(width + 2, ' ');
    text += "  " + assignment + field.help + "\n";
  }
  return text;
}

std::pair<int, int> parse_size(const std::string& text) {
  const auto cross = text.find('x');
  try {
    vo::require(cross != std::string::npos, "no x");
    const std::int64_t width = vo::parse_integer(text.substr(0, cross));
    const std::int64_t height = vo::parse_integer(text.substr(cross + 1));
    vo::require(std::in_range<int>(width) && std::in_range<int>(height), "too large");
    return {static_cast<int>(width), static_cast<int>(height)};
  } catch (const vo::Error&) {
    vo::fail_as(vo::ErrorKind::usage, "--size ", text, ": expected WIDTHxHEIGHT, such as 640x480");
  }
}

}  // namespace tools
