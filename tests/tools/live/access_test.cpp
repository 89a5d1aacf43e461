#include "tools/live/access.h"

#include <set>

#include <gtest/gtest.h>

namespace {

using tools::AccessRule;

const AccessRule& rule() {
  static const AccessRule known(8080, "abcd");
  return known;
}

TEST(AccessRule, AllowsWhoKnowsTheToken) {
  EXPECT_EQ(rule().refusal({"127.0.0.1:8080", {}, "abcd"}), "");
  EXPECT_EQ(rule().refusal({"localhost:8080", "http://localhost:8080", "abcd"}), "");
}

TEST(AccessRule, RefusesAnyOtherToken) {
  for (const char* token : {"", "abc", "abcde", "abce", "ABCD"}) {
    EXPECT_NE(rule().refusal({"127.0.0.1:8080", {}, token}), "") << token;
  }
}

TEST(AccessRule, RefusesAHostThatANameOfAnotherSiteMayLeadTo) {
  for (const char* host : {"", "evil.example:8080", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:80801",
                           "127.0.0.1.evil.example:8080"}) {
    EXPECT_NE(rule().refusal({host, {}, "abcd"}), "") << host;
  }
}

TEST(AccessRule, RefusesAnotherOriginWithTheTokenToo) {
  for (const char* origin : {"", "null", "https://127.0.0.1:8080", "http://localhost:8080",
                             "http://127.0.0.1:8081", "http://evil.example"}) {
    EXPECT_NE(rule().refusal({"127.0.0.1:8080", origin, "abcd"}), "") << origin;
  }
}

TEST(RandomToken, IsLongAndNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = tools::random_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    tokens.insert(token);
  }
  EXPECT_EQ(tokens.size(), 100U);
}

}  // namespace
