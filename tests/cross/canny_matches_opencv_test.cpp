#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/support/instruction_sets.h"
#include "vo/core/hash.h"
#include "vo/edges/canny.h"
#include "vo/edges/sobel_magnitudes.h"

namespace {

using vo::InstructionSet;

/// Noise smoothed at several scales: edges of every direction, strength and length, and ties.
vo::ByteImage clouds(cv::Size size, std::uint64_t seed) {
  cv::Mat_<float> image(size, 0.0F);
  for (const int scale : {1, 4, 16}) {
    cv::Mat_<float> noise(size.height / scale + 1, size.width / scale + 1);
    for (int i = 0; i < static_cast<int>(noise.total()); ++i) {
      noise(i / noise.cols, i % noise.cols) = static_cast<float>(
          vo::mixed_uniform(seed * 1000000 + static_cast<std::uint64_t>(i * 3 + scale)));
    }
    cv::resize(noise, noise, size, 0, 0, cv::INTER_CUBIC);
    image += 25.0F * static_cast<float>(std::sqrt(scale)) * noise;
  }
  vo::ByteImage bytes;
  image.convertTo(bytes, CV_8U);
  return bytes;
}

struct Gradients {
  cv::Mat dx, dy;  // 16 bit

  explicit Gradients(const vo::ByteImage& image) {
    cv::Sobel(image, dx, CV_16S, 1, 0, 3, 1, 0, cv::BORDER_REPLICATE);
    cv::Sobel(image, dy, CV_16S, 0, 1, 3, 1, 0, cv::BORDER_REPLICATE);
  }
};

TEST(Canny, FindsTheEdgesOfOpenCv) {
  vo::Canny canny;
  for (const cv::Size size : {cv::Size(160, 120), {161, 97}, {17, 5}, {3, 4}, {1, 1}}) {
    for (const double strong : {20.0, 63.5, 150.0, 400.0}) {
      const vo::ByteImage image = clouds(size, static_cast<std::uint64_t>(size.width));
      const Gradients gradients(image);
      cv::Mat expected;
      cv::Canny(gradients.dx, gradients.dy, expected, strong / 2, strong, /*L2gradient=*/true);
      for (const InstructionSet set : support::instruction_sets_of_this_machine()) {
        vo::EdgeMask found;
        canny.find(image, strong / 2, strong, set, found);
        EXPECT_EQ(cv::norm(found, expected, cv::NORM_INF), 0) << size << " strong " << strong;
      }
    }
  }
}

TEST(Canny, CountsTheMagnitudesOfOpenCv) {
  for (const int row_step : {1, 3}) {
    const vo::ByteImage image = clouds({163, 120}, 5);
    const Gradients gradients(image);
    std::vector<int> expected(vo::SobelMagnitudes::kGreatest + 1);
    for (int v = row_step / 2; v < image.rows; v += row_step) {
      for (int u = 0; u < image.cols; ++u) {
        ++expected.at(static_cast<std::size_t>(
            std::hypot(gradients.dx.at<short>(v, u), gradients.dy.at<short>(v, u))));
      }
    }
    for (const InstructionSet set : support::instruction_sets_of_this_machine()) {
      vo::SobelMagnitudes magnitudes;
      magnitudes.measure(image, row_step, set);
      EXPECT_EQ(magnitudes.count(), 163 * 120 / row_step);
      int below = 0;
      for (int magnitude = 0; magnitude <= vo::SobelMagnitudes::kGreatest; ++magnitude) {
        EXPECT_EQ(magnitudes.count_below(magnitude), below) << magnitude;
        below += expected[static_cast<std::size_t>(magnitude)];
      }
    }
  }
}

}  // namespace
