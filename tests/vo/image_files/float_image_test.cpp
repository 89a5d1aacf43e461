#include "vo/image_files/float_image.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/image_files/flow_file.h"

namespace {

using support::TempFolder;
using testing::HasSubstr;

cv::Mat ramp(int type) {
  cv::Mat image(5, 7, type);
  for (int v = 0; v < image.rows; ++v) {
    for (int i = 0; i < image.cols * image.channels(); ++i) {
      image.ptr<float>(v)[i] = 0.1F * static_cast<float>(i) + static_cast<float>(v * v);
    }
  }
  image.at<float>(2, 1) = std::numeric_limits<float>::denorm_min();
  return image;
}

TEST(FloatImage, EachFormatReadsBackToTheBit) {
  const TempFolder folder;
  for (const vo::FloatFormat format :
       {vo::FloatFormat::npy, vo::FloatFormat::pfm, vo::FloatFormat::tiff}) {
    for (const int type : {CV_32FC1, CV_32FC3}) {
      const cv::Mat image = ramp(type);
      const std::string name = "a." + std::string(format == vo::FloatFormat::npy   ? "npy"
                                                  : format == vo::FloatFormat::pfm ? "pfm"
                                                                                   : "tiff");
      const cv::Mat copy =
          vo::read_float_image(folder.write(name, vo::encode_float_image(image, format)));
      ASSERT_EQ(copy.type(), type) << name;
      ASSERT_EQ(copy.size(), image.size()) << name;
      EXPECT_EQ(cv::norm(copy, image, cv::NORM_INF), 0) << name;
    }
  }
}

TEST(FloatImage, WhatIsCutOrOfAnotherKindIsAnError) {
  const TempFolder folder;
  for (const char* name : {"a.npy", "a.pfm", "a.tiff"}) {
    const vo::FloatFormat format = name[2] == 'n'   ? vo::FloatFormat::npy
                                   : name[2] == 'p' ? vo::FloatFormat::pfm
                                                    : vo::FloatFormat::tiff;
    const std::string bytes = vo::encode_float_image(ramp(CV_32FC3), format);
    for (std::size_t size = 0; size < bytes.size(); size += 7) {
      const auto path = folder.write(name, bytes.substr(0, size));
      EXPECT_THAT(support::error_text([&] { vo::read_float_image(path); }), HasSubstr(name))
          << size << " bytes";
    }
  }
  EXPECT_THAT(support::error_text([] { vo::read_float_image("a.png"); }),
              HasSubstr("expected a float image"));
}

TEST(FlowFile, ReadsBackToTheBitAndRefusesWhatIsCut) {
  const TempFolder folder;
  cv::Mat_<cv::Vec2f> flow(3, 4);
  for (int i = 0; i < 12; ++i) {
    flow(i / 4, i % 4) = {0.5F * static_cast<float>(i), -1e10F};
  }
  const std::string bytes = vo::encode_flow(flow);
  EXPECT_EQ(bytes.substr(0, 4), "PIEH");
  EXPECT_EQ(bytes.size(), 12 + 12 * 8U);
  const auto copy = vo::read_flow(folder.write("a.flo", bytes));
  EXPECT_EQ(cv::norm(copy, flow, cv::NORM_INF), 0);
  const auto cut = folder.write("cut.flo", bytes.substr(0, 50));
  EXPECT_THAT(support::error_text([&] { vo::read_flow(cut); }), HasSubstr("cut.flo"));
}

}  // namespace
