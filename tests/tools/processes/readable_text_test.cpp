#include "tools/processes/readable_text.h"

#include <gtest/gtest.h>

namespace {

using tools::readable_text;

TEST(ReadableText, KeepsWhatIsUtf8) {
  const std::string text = "room \u00e9 \u20ac \U0001f4f7";
  EXPECT_EQ(readable_text(text), text);
}

TEST(ReadableText, ReplacesControlCharactersAndWhatIsNotUtf8) {
  EXPECT_EQ(readable_text("a\n\tb\x7f"), "a??b?");
  EXPECT_EQ(readable_text("\xff\xfe"), "??");
  EXPECT_EQ(readable_text("\xc3"), "?") << "cut off";
  EXPECT_EQ(readable_text("\xc3("), "?(");
  EXPECT_EQ(readable_text("\xc0\xaf"), "??") << "overlong";
  EXPECT_EQ(readable_text("\xed\xa0\x80"), "???") << "half of a UTF-16 pair";
  EXPECT_EQ(readable_text("\xf4\x90\x80\x80"), "????") << "beyond the last";
}

}  // namespace
