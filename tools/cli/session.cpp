#include "tools/cli/session.h"

#include <algorithm>
#include <string_view>

#include <unistd.h>

#include "tools/cli/options.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

constexpr const char* kColourOption = "--color";

ColourChoice colour_choice(const std::vector<std::string>& words) {
  const std::string joined = std::string(kColourOption) + "=";
  std::string chosen(vo::to_string(ColourChoice::automatic));
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    if (words[i].starts_with(joined)) {
      chosen = words[i].substr(joined.size());
    } else if (words[i] == kColourOption && i + 1 < words.size()) {
      chosen = words[i + 1];
    }
  }
  const std::vector<std::string_view> names = vo::names_of<ColourChoice>();
  const bool is_known = std::find(names.begin(), names.end(), chosen) != names.end();
  return is_known ? vo::parse_enum<ColourChoice>(chosen) : ColourChoice::automatic;
}

/// Returns the text with its control characters but tabs and newlines as `\x1B`, so that a name
/// from a file cannot move the cursor of the terminal that shows it.
std::string printable(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  constexpr unsigned char kDelete = 0x7F;
  std::string shown;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' ? byte != kDelete : c == '\t' || c == '\n') {
      shown += c;
    } else {
      shown += {'\\', 'x', kDigits[byte / 16U], kDigits[byte % 16U]};
    }
  }
  return shown;
}

}  // namespace

Session start_session(const std::vector<std::string>& words) {
  const ColourEnvironment environment = colour_environment();
  const ColourChoice choice = colour_choice(words);
  const auto colours = [&](int stream) {
    return colours_of(kind_of_stream(stream, environment), choice, environment);
  };
  return {.out = colours(STDOUT_FILENO), .err = colours(STDERR_FILENO)};
}

void add_colour_option(CLI::App& program) {
  program
      .add_option_function<std::string>(
          kColourOption, [](const std::string&) {},
          "auto | always | never; auto: on a terminal, without NO_COLOR [auto]")
      ->check(is_name_of<ColourChoice>());
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    add_colour_option(*command);
  }
}

std::string error_text(const Colours& colours, const std::string& message) {
  const std::string shown = printable(message);
  const std::size_t end = std::min(shown.find('\n'), shown.size());
  return colours.paint(Tone::bad, shown.substr(0, end)) + shown.substr(end);
}

std::string error_line(const Colours& colours, const std::string& text) {
  return colours.paint(Tone::bad, "edvo:") + " " + printable(text) + "\n";
}

}  // namespace tools
