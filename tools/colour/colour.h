#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tools {

/// A Tone says what a word means to its reader.
enum class Tone {
  good,     ///< a bound holds, a test passed: green
  bad,      ///< an error, a bound that does not hold: bold red
  caution,  ///< what must not be relied on, a warning: yellow
};

/// The colours of one stream, a value that is handed to what formats a text for it. Colours by
/// default are none: a text stays as it is. A text without its escape sequences is that same text.
class Colours {
 public:
  /// Returns colours that are shown, as ECMA-48 has them: `ESC [ 32 m` and so on.
  static Colours shown();

  bool are_shown() const { return are_shown_; }

  /// Returns the text in its tone; the text alone where it is empty or no colours are shown.
  std::string paint(Tone tone, std::string_view text) const;

 private:
  bool are_shown_ = false;
};

/// Returns a line `note  ...` for each note, a sentence that its reader must know of a result.
std::string note_lines(const std::vector<std::string>& notes, const Colours& colours);

/// A ColourChoice is what a user says of colours (`--color`).
enum class ColourChoice { automatic, always, never };

constexpr auto enum_names(ColourChoice) {
  return std::array{std::pair{ColourChoice::automatic, "auto"},
                    std::pair{ColourChoice::always, "always"},
                    std::pair{ColourChoice::never, "never"}};
}

/// A ColourEnvironment holds the variables that decide on colours; one that is not set is empty.
struct ColourEnvironment {
  std::string no_color;        ///< NO_COLOR (no-color.org)
  std::string clicolor_force;  ///< CLICOLOR_FORCE
  std::string term;            ///< TERM
};

/// Reads the environment of this process.
ColourEnvironment colour_environment();

/// A StreamKind says whether a stream leads to a terminal.
enum class StreamKind { terminal, other };

/// Returns whether a descriptor is a terminal that moves its cursor, which none of TERM=dumb does.
StreamKind kind_of_stream(int descriptor, const ColourEnvironment& environment);

/// Returns the colours of a stream. The user's choice counts first; `automatic` asks NO_COLOR (not
/// empty: none), then CLICOLOR_FORCE (neither empty nor 0: shown), then what the stream leads to.
Colours colours_of(StreamKind stream, ColourChoice choice, const ColourEnvironment& environment);

}  // namespace tools
