#include "tools/plot/table.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/plot/linear_fit.h"
#include "tools/plot/statistics.h"

namespace {

tools::Table small_table() {
  tools::Table table{.columns = {{"what"}, {"error_mm", 2}, {"count"}}};
  table.add_row({"edges, few", 1.0 / 3, 12.0});
  table.add_row({"all", std::numeric_limits<double>::quiet_NaN(), 307200.0});
  return table;
}

TEST(AblateTable, CsvHasEveryDigitAndQuotesCommas) {
  EXPECT_EQ(tools::as_csv(small_table()),
            "what,error_mm,count\n\"edges, few\",0.3333333333333333,12\nall,,307200\n");
}

TEST(AblateTable, TextOfAnyCharactersIsOneCell) {
  tools::Table table{.columns = {{"what"}, {"n"}}};
  table.add_row({"a \"b\"\nc|d", 1.0});
  EXPECT_EQ(tools::as_csv(table), "what,n\n\"a \"\"b\"\"\nc|d\",1\n");
  EXPECT_EQ(tools::as_markdown(table), "| what | n |\n|---|---:|\n| a \"b\" c\\|d | 1 |\n");
}

TEST(AblateTable, MarkdownAndTextRoundForPeople) {
  EXPECT_EQ(tools::as_markdown(small_table()),
            "| what | error_mm | count |\n|---|---:|---:|\n| edges, few | 0.33 | 12 |\n"
            "| all | - | 307200 |\n");
  EXPECT_EQ(tools::as_text(small_table()),
            "what        error_mm   count\n"
            "edges, few      0.33      12\n"
            "all                -  307200\n");
}

TEST(AblateTable, JsonHasAnObjectPerRow) {
  const auto json = tools::as_json(small_table());
  EXPECT_EQ(json[0]["error_mm"], 1.0 / 3);
  EXPECT_TRUE(json[1]["error_mm"].is_null());
}

TEST(LinearFit, FindsALineExactly) {
  const std::vector<double> x{1, 2, 5, 9};
  std::vector<double> y;
  for (const double value : x) {
    y.push_back(0.25 + 3 * value);
  }
  const tools::LinearFit fit = tools::fit_line(x, y).value();
  EXPECT_NEAR(fit.slope, 3, 1e-12);
  EXPECT_NEAR(fit.intercept, 0.25, 1e-12);
  EXPECT_NEAR(fit.r_squared, 1, 1e-12);
}

TEST(LinearFit, MatchesItsClosedForm) {
  const std::vector<double> x{0, 1, 2};
  const std::vector<double> y{0, 1, 0};
  const tools::LinearFit level = tools::fit_line(x, y).value();
  EXPECT_NEAR(level.slope, 0, 1e-12);
  EXPECT_NEAR(level.intercept, 1.0 / 3, 1e-12);
  EXPECT_NEAR(level.r_squared, 0, 1e-12);
  const std::vector<double> steps{0, 0, 1};
  const tools::LinearFit rising = tools::fit_line(x, steps).value();
  EXPECT_NEAR(rising.slope, 0.5, 1e-12);
  EXPECT_NEAR(rising.r_squared, 0.75, 1e-12) << "cov^2 / (var var) = (1/2)^2 / (1 * 1/3)";
}

TEST(Spread, IsMeanAndSampleDeviationOfFiniteValues) {
  const std::vector<double> values{1, 3, std::nan(""), 5};
  EXPECT_EQ(tools::spread(values).mean, 3);
  EXPECT_EQ(tools::spread(values).deviation, 2);
  EXPECT_EQ(tools::spread(std::vector{7.0}).deviation, 0);
  EXPECT_TRUE(std::isnan(tools::spread({}).mean));
  EXPECT_EQ(tools::median({5, 1, 3}), 3);
  EXPECT_EQ(tools::median({5, 1, 3, 4}), 3.5);
}

}  // namespace
