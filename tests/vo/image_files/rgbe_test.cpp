#include "vo/image_files/rgbe.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/same_pixels.h"
#include "tests/support/temp_folder.h"

namespace vo {
namespace {

using support::error_text;
using testing::HasSubstr;

const std::string kHeader = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n\n";

std::string bytes_of(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) {
    bytes.push_back(static_cast<char>(value));
  }
  return bytes;
}

class Rgbe : public testing::Test {
 protected:
  cv::Mat_<cv::Vec3f> read(const std::string& bytes) const {
    return read_rgbe(folder_.write("light.hdr", bytes));
  }
  std::string error_of(const std::string& bytes) const {
    return error_text([&] { read(bytes); });
  }

  support::TempFolder folder_;
};

TEST_F(Rgbe, AWrittenImageIsReadToEightBitsOfItsBrightestChannel) {
  cv::Mat_<cv::Vec3f> image(7, 12);
  for (int i = 0; i < 84; ++i) {
    const float value = std::ldexp(1.0F + static_cast<float>(i) / 84, i - 42);
    image(i / 12, i % 12) = {value, value / 3, value / 100};
  }
  image(3, 3) = {0, 0, 0};
  const cv::Mat_<cv::Vec3f> again = read(encode_rgbe(image));
  ASSERT_EQ(again.size(), image.size());
  for (int i = 0; i < 84; ++i) {
    const cv::Vec3f& expected = image(i / 12, i % 12);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(again(i / 12, i % 12)[channel], expected[channel], expected[0] / 128);
    }
  }
}

TEST_F(Rgbe, RunsAndLiteralsOfChannelsAreUnpacked) {
  const cv::Mat_<cv::Vec3f> image =
      read(kHeader + "-Y 1 +X 8\n" + bytes_of({2, 2, 0, 8}) +              // packed, 8 px
           bytes_of({128 + 8, 128}) +                                      // red: 8 times 128
           bytes_of({3, 0, 64, 128}) + bytes_of({128 + 5, 255}) +          // green
           bytes_of({8, 1, 2, 3, 4, 5, 6, 7, 8}) + bytes_of({136, 129}));  // blue; exponents
  EXPECT_EQ(image(0, 0), cv::Vec3f(1, 0, 1 / 128.0F));
  EXPECT_EQ(image(0, 1), cv::Vec3f(1, 0.5F, 2 / 128.0F));
  EXPECT_EQ(image(0, 7), cv::Vec3f(1, 255 / 128.0F, 8 / 128.0F));
}

TEST_F(Rgbe, RunsOfPixelsAreUnpackedAndExposureIsTakenOut) {
  const cv::Mat_<cv::Vec3f> image = read("#?RGBE\nEXPOSURE=4\nEXPOSURE=0.5\n\n-Y 1 +X 6\n" +
                                         bytes_of({128, 64, 32, 130, 1, 1, 1, 4, 0, 128, 0, 129}));
  for (int u = 0; u < 5; ++u) {
    EXPECT_EQ(image(0, u), cv::Vec3f(1, 0.5F, 0.25F));  // 2 over 2
  }
  EXPECT_EQ(image(0, 5), cv::Vec3f(0, 0.5F, 0));
}

TEST_F(Rgbe, SaysWhatIsWrong) {
  EXPECT_THAT(error_of("\x89PNG"), HasSubstr("light.hdr: expected an image of linear light"));
  EXPECT_THAT(error_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n"),
              HasSubstr("is of FORMAT=32-bit_rle_xyze, expected 32-bit_rle_rgbe"));
  EXPECT_THAT(error_of("#?RADIANCE\n"), HasSubstr("ends within its header"));
  EXPECT_THAT(error_of(kHeader + "+X 8 -Y 4\n"), HasSubstr("expected -Y HEIGHT +X WIDTH"));
  EXPECT_THAT(error_of(kHeader + "-Y 16384 +X 16384\n"),
              HasSubstr("is 16384 x 16384 px, expected at most 67108864 pixels"));
  EXPECT_THAT(error_of("#?RADIANCE\nEXPOSURE=nan\n\n-Y 1 +X 1\n"),
              HasSubstr("its EXPOSURE is nan, expected a positive number"));
  EXPECT_THAT(error_of(kHeader + "-Y 1 +X 8\n" + bytes_of({2, 2, 0, 8, 128 + 9, 1})),
              HasSubstr("has a run beyond the end of a row"));
  EXPECT_THAT(error_of(kHeader + "-Y 2 +X 1\n" + bytes_of({1, 2, 3, 4, 5})),
              HasSubstr("ends before its last pixel"));
  EXPECT_THAT(error_of(kHeader + "-Y 1 +X 4\n" + bytes_of({1, 1, 1, 1})),
              HasSubstr("has a run beyond the end of a row"));
}

}  // namespace
}  // namespace vo
