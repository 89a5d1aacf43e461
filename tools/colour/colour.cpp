#include "tools/colour/colour.h"

#include <cstdlib>

#include <unistd.h>

namespace tools {
namespace {

std::string_view escape_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "\033[32m";
    case Tone::bad:
      return "\033[1;31m";
    case Tone::caution:
      return "\033[33m";
  }
  return {};
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing sets variables
  return value == nullptr ? "" : value;
}

}  // namespace

Colours Colours::shown() {
  Colours colours;
  colours.are_shown_ = true;
  return colours;
}

std::string Colours::paint(Tone tone, std::string_view text) const {
  std::string painted(text);
  if (are_shown_ && !text.empty()) {
    painted.insert(0, escape_of(tone));
    painted += "\033[0m";
  }
  return painted;
}

std::string note_lines(const std::vector<std::string>& notes, const Colours& colours) {
  std::string text;
  for (const std::string& note : notes) {
    text += colours.paint(Tone::caution, "note") + "  " + note + "\n";
  }
  return text;
}

ColourEnvironment colour_environment() {
  return {variable("NO_COLOR"), variable("CLICOLOR_FORCE"), variable("TERM")};
}

StreamKind kind_of_stream(int descriptor, const ColourEnvironment& environment) {
  const bool is_able = !environment.term.empty() && environment.term != "dumb";
  return is_able && ::isatty(descriptor) != 0 ? StreamKind::terminal : StreamKind::other;
}

Colours colours_of(StreamKind stream, ColourChoice choice, const ColourEnvironment& environment) {
  const bool is_forced = !environment.clicolor_force.empty() && environment.clicolor_force != "0";
  const bool is_automatic =
      environment.no_color.empty() && (is_forced || stream == StreamKind::terminal);
  const bool are_shown =
      choice == ColourChoice::automatic ? is_automatic : choice == ColourChoice::always;
  return are_shown ? Colours::shown() : Colours();
}

}  // namespace tools
