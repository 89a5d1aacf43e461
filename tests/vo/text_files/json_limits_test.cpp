#include "vo/text_files/json_limits.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

std::string limits_error(const std::string& text) {
  return support::error_text([&] { vo::require_json_within_limits(text, "a.json"); });
}

TEST(JsonLimits, TooDeepIsAnError) {
  for (const char* open : {"[", "{\"a\":", "[{\"\\\"\":"}) {
    std::string text;
    for (int i = 0; i < 15'000; ++i) {
      text += open;
    }
    EXPECT_THAT(limits_error(text),
                testing::StartsWith("a.json: its JSON is nested more than 100"));
  }
}

TEST(JsonLimits, BracketsOfStringsAndSiblingsDoNotNest) {
  const std::string brackets(200, '[');
  EXPECT_EQ(limits_error("{\"" + brackets + "\": \"\\\"" + brackets + "\\\\\"}"), "no error");
  std::string siblings = "[";
  for (int i = 0; i < 200; ++i) {
    siblings += "[], {}, ";
  }
  EXPECT_EQ(limits_error(siblings + "0]"), "no error");
  EXPECT_EQ(limits_error(std::string(100, '[') + std::string(100, ']')), "no error");
}

TEST(JsonLimits, MoreValuesThanMemoryHoldsIsAnError) {
  EXPECT_THAT(limits_error("[" + std::string(21'000'000, ',')),
              testing::HasSubstr("has more than 20000000 values"));
}

TEST(JsonLimits, LeaveWhatDoesNotEndToTheParser) {
  for (const char* text : {"\"", "\"\\", "\"\\\"", "[", "]", ""}) {
    EXPECT_EQ(limits_error(text), "no error") << text;
  }
}

}  // namespace
