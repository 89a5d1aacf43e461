#include "tools/colour/colour.h"

#include <gtest/gtest.h>

namespace {

using tools::ColourChoice;
using tools::ColourEnvironment;
using tools::Colours;
using tools::colours_of;
using tools::StreamKind;
using tools::Tone;

bool are_shown(StreamKind stream, ColourChoice choice, const ColourEnvironment& environment) {
  return colours_of(stream, choice, environment).are_shown();
}

TEST(Colours, PaintNothingByDefault) {
  EXPECT_EQ(Colours().paint(Tone::bad, "FAIL"), "FAIL");
  EXPECT_FALSE(Colours().are_shown());
}

TEST(Colours, EndWithTheWordThatHasThem) {
  EXPECT_EQ(Colours::shown().paint(Tone::bad, "FAIL"), "\033[1;31mFAIL\033[0m");
  EXPECT_EQ(Colours::shown().paint(Tone::good, "PASS"), "\033[32mPASS\033[0m");
  EXPECT_EQ(Colours::shown().paint(Tone::caution, "note"), "\033[33mnote\033[0m");
  EXPECT_EQ(Colours::shown().paint(Tone::caution, ""), "") << "no empty sequences";
}

TEST(Colours, AreThoseOfATerminalUnlessTheEnvironmentSaysOtherwise) {
  const ColourEnvironment xterm{.no_color = "", .clicolor_force = "", .term = "xterm"};
  EXPECT_TRUE(are_shown(StreamKind::terminal, ColourChoice::automatic, xterm));
  EXPECT_FALSE(are_shown(StreamKind::other, ColourChoice::automatic, xterm));
  ColourEnvironment forced = xterm;
  forced.clicolor_force = "1";
  EXPECT_TRUE(are_shown(StreamKind::other, ColourChoice::automatic, forced));
  forced.clicolor_force = "0";
  EXPECT_FALSE(are_shown(StreamKind::other, ColourChoice::automatic, forced));
  ColourEnvironment unwanted{.no_color = "1", .clicolor_force = "1", .term = "xterm"};
  EXPECT_FALSE(are_shown(StreamKind::terminal, ColourChoice::automatic, unwanted));
}

TEST(Colours, AreAsTheCommandLineSaysWhateverTheEnvironment) {
  const ColourEnvironment unwanted{.no_color = "1", .clicolor_force = "", .term = "dumb"};
  EXPECT_TRUE(are_shown(StreamKind::other, ColourChoice::always, unwanted));
  const ColourEnvironment forced{.no_color = "", .clicolor_force = "1", .term = "xterm"};
  EXPECT_FALSE(are_shown(StreamKind::terminal, ColourChoice::never, forced));
}

}  // namespace
