#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/text_files/toml_file.h"

namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// The text, so many times.
std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) {
    result += text;
  }
  return result;
}

std::vector<vo::TomlValue> nested_values(const std::string& text) {
  const support::TempFolder folder;
  return vo::read_toml(folder.write("a.toml", text));
}

std::string nesting_error(const std::string& text) {
  return support::error_text([&] { nested_values(text); });
}

TEST(TomlNesting, TooDeepIsAnError) {
  const std::string deep = repeated("a.", 15000);
  EXPECT_THAT(nesting_error("x = 1\n" + deep + "a = 1\n"),
              EndsWith("a.toml:2: a key has more than 64 parts"));
  EXPECT_THAT(nesting_error("[" + deep + "a]\n"), HasSubstr("more than 64 parts"));
  EXPECT_THAT(nesting_error("x = {" + deep + "a = 1}\n"), HasSubstr("more than 64 parts"));
  EXPECT_THAT(nesting_error("x = " + repeated("{a = ", 200) + "1" + repeated("}", 200) + "\n"),
              HasSubstr("more than 16 inline tables"));
  EXPECT_NE(nesting_error("x = " + repeated("[", 100000)), "no error");
}

TEST(TomlNesting, OfOrdinaryFilesIsRead) {
  const std::string dots = repeated(".", 200);
  EXPECT_EQ(nested_values(repeated("a.", 63) + "a = 1\n").size(), 1U);
  EXPECT_EQ(
      nested_values("# " + dots + "\na = \"" + dots + "\\\"" + dots + "\"\nb = '" + dots + "'\n")
          .size(),
      2U);
  EXPECT_EQ(nested_values("c = '''" + dots + "\n'" + dots + "'''\nd = \"\"\"" + dots + "\n" + dots +
                          "\"\"\"\n")
                .size(),
            2U);
  EXPECT_EQ(nested_values("a = [" + repeated("1.5, 2.5,\n", 100) + "]\nb = {c.d = 1.5}\n").size(),
            2U);
}

}  // namespace
