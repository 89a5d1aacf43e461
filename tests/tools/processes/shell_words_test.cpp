#include "tools/processes/shell_words.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/input.h"

namespace {

using support::error_text;
using testing::ElementsAre;
using testing::HasSubstr;
using tools::script_indices;
using tools::split_words;

/// The words that /bin/sh makes of a text, read from a program that prints each on a line.
std::vector<std::string> words_of_shell(const std::string& text) {
  const support::TempFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string command = "set -f; printf '%s\\n' " + text + " > '" + out + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
  std::vector<std::string> words;
  std::string word;
  for (const char c : vo::read_file(out)) {
    if (c == '\n') {
      words.push_back(std::exchange(word, ""));
    } else {
      word += c;
    }
  }
  return words;
}

TEST(ShellWords, AreThoseOfTheShell) {
  for (const std::string text :
       {R"(vo  --in a.b	--out c)", R"('a b' "c d" e\ f)", R"(a'b'"c"d '' "" x)",
        R"(a\\b 'a\b' "a\b")", R"("a\"b" "a\\b" "a\$b" "a\`b" '$(x)' '`x`')",
        R"(a\'b "it's" 'say "x"')", R"(--set=a#b a~b {sequence}/x * ? [ab])",
        "a\\\nb \"c\\\nd\""}) {
    EXPECT_EQ(split_words(text), words_of_shell(text)) << text;
  }
}

TEST(ShellWords, ThatAreQuotedAreReadBack) {
  for (const std::string text : {"a", "", "it's $x", "a\\b\n\"c\""}) {
    EXPECT_THAT(split_words("vo " + tools::shell_quoted(text)), ElementsAre("vo", text));
  }
}

TEST(ShellWords, NeedNoShell) {
  for (const char* text : {"a | b", "a>b", "a && b", "a; b", "a $(b)", "a `b`", "a $B", "a <b",
                           "a # b", "~/vo", "(a)", "a\nb"}) {
    EXPECT_THAT(error_text([&] { split_words(text); }), HasSubstr("which only a shell understands"))
        << text;
  }
  EXPECT_THAT(error_text([] { split_words("a 'b"); }), HasSubstr("has a ' without its other"));
  EXPECT_THAT(error_text([] { split_words("a \"b"); }), HasSubstr("has a \" without its other"));
  EXPECT_THAT(error_text([] { split_words("a\\"); }), HasSubstr("ends with a backslash"));
}

TEST(ShellWords, AreNotExpanded) {
  EXPECT_THAT(split_words(R"(sh -c "vo <$A >\"$B\" `c`")"),
              ElementsAre("sh", "-c", "vo <$A >\"$B\" `c`"));
}

TEST(ShellWords, ThatAShellRunsAsAScriptAreFound) {
  EXPECT_THAT(script_indices({"sh", "-c", "x", "y"}), ElementsAre(2U));
  EXPECT_THAT(script_indices({"timeout", "9", "/bin/bash", "-e", "-uc", "x"}), ElementsAre(5U));
  EXPECT_THAT(script_indices({"sh", "-c", "-e", "x"}), ElementsAre(3U));
  EXPECT_THAT(script_indices({"sh", "vo.sh", "-c", "x"}), ElementsAre());
  EXPECT_THAT(script_indices({"python3", "-c", "x"}), ElementsAre());
  EXPECT_THAT(script_indices({"sh", "-c"}), ElementsAre());
}

}  // namespace
