#include "vo/motion_files/timestamp.h"

#include <charconv>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Timestamps, HaveSixDecimalsWhereThatTellsThemApart) {
  EXPECT_THAT(vo::format_timestamps({0, 1.0 / 30, 1305031102.175304}),
              ElementsAre("0.000000", "0.033333", "1305031102.175304"));
  EXPECT_TRUE(vo::format_timestamps({}).empty());
}

TEST(Timestamps, OnBothSidesOfZeroAreToldApart) {
  EXPECT_THAT(vo::format_timestamps({-1.5e-6, -1e-8, 1}),
              ElementsAre("-0.000002", "0.000000", "1.000000"));
  EXPECT_THAT(vo::format_timestamps({-1e-8, 0}), ElementsAre("-0.00000001", "0"));
}

TEST(Timestamps, ThatSixDecimalsDoNotTellApartReadBackAsTheyWere) {
  const std::vector<double> timestamps = {std::numeric_limits<double>::denorm_min(),
                                          1e-17,
                                          1e-7,
                                          1.0 / 3,
                                          1305031102.1753041,
                                          1305031102.1753044};
  const std::vector<std::string> texts = vo::format_timestamps(timestamps);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(texts[i].find('e'), std::string::npos);
    double value = 0;
    std::from_chars(texts[i].data(), texts[i].data() + texts[i].size(), value);
    EXPECT_EQ(value, timestamps[i]);
  }
}

TEST(Timestamps, WithinOneNanosecondAreNamed) {
  EXPECT_NO_THROW(vo::require_nanoseconds_apart({0, 1e-9, 2e-9}, "in"));
  EXPECT_THAT(support::error_text([] {
                vo::require_nanoseconds_apart({0, 0.5, 0.5000000001}, "in");
              }),
              HasSubstr("in: frames 1 and 2 lie within a nanosecond (0.5 s and 0.5000000001 s)"));
  EXPECT_THAT(support::error_text([] {
                vo::require_nanoseconds_apart({0, 1e-300}, "in");
              }),
              HasSubstr("(0 s and 1e-300 s)"));
}

}  // namespace
