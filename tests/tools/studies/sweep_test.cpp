#include "tools/studies/sweep.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

using support::error_text;
using testing::HasSubstr;

TEST(SweptScenarios, MoreCombinationsThanATableHoldsAreRefusedBeforeAnyIsMade) {
  const std::vector<std::string> values(400, "1");
  const std::vector<tools::SweptOption> options{{"a", values}, {"b", values}, {"c", values}};
  EXPECT_THAT(error_text([&] { tools::swept_scenarios({"none.toml"}, options); }),
              HasSubstr("--set: the values have 6.4e+07 combinations over all scenarios"));
}

TEST(SweptScenarios, ATableThatCanBeReadIsBegun) {
  const std::vector<std::string> values(300, "1");
  EXPECT_THAT(error_text([&] {
                tools::swept_scenarios({"none.toml"}, {{"a", values}});
              }),
              HasSubstr("none.toml"));
}

}  // namespace
