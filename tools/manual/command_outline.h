#pragma once

#include <string>
#include <vector>

namespace tools {

/// An OptionValue says what a shell may propose after an option.
enum class OptionValue {
  none,  ///< the option is a flag
  text,  ///< a text, a number or the name of a file
};

/// One option of a command.
struct OptionOutline {
  std::string name;  ///< `--out`, or the name of a positional argument, `SEQUENCE`
  OptionValue value = OptionValue::none;
  std::string help;
  bool is_positional = false;
  bool is_required = false;
};

/// A command with its options and subcommands, in the order in which its help lists them.
struct CommandOutline {
  std::string name;  ///< word, `render`
  std::string description;
  std::string footer;  ///< examples and keys
  std::vector<OptionOutline> options;
  std::vector<CommandOutline> commands;
};

/// Returns the first sentence of a description, or its first line where that is shorter, without
/// the full stop.
std::string summary(const std::string& description);

}  // namespace tools
