#include "synth/depth_sensor/depth_multipath.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace synth {
namespace {

using Complex = std::complex<double>;

const MultipathOptions kSent{.frequency = 100e6};

const vo::PinholeCamera kEye{.width = 24, .height = 16, .fx = 20, .fy = 20, .cx = 11.5, .cy = 7.5};

/// A wall 2 m away that returns 0.25, and other light over it that is linear in place.
RenderedFrame lit_wall_ahead() {
  const cv::Size size(kEye.width, kEye.height);
  RenderedFrame frame;
  frame.depth = vo::DepthImage(size, 2.0F);
  frame.normal = cv::Mat_<cv::Vec3f>(size, cv::Vec3f(0, 0, -1));
  frame.sight.first = cv::Mat_<std::uint8_t>(size, std::uint8_t{0});
  frame.sight.beyond = frame.depth.clone();
  frame.sight.beyond_normal = frame.normal.clone();
  frame.sight.beyond_returned = cv::Mat_<float>(size, 0.25F);
  frame.sight.multipath = cv::Mat_<cv::Vec2f>(size);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      frame.sight.multipath(v, u) =
          0.25F * cv::Vec2f(0.1F + 0.01F * static_cast<float>(v), 0.02F * static_cast<float>(u));
    }
  }
  return frame;
}

/// Returns the depth of a place of that wall in closed form.
double lengthened_depth(const cv::Point& pixel) {
  const Complex ratio(0.1 + 0.01 * pixel.y, 0.02 * pixel.x);
  const double detour = std::arg(1.0 + ratio) * 299792458 / (4 * std::numbers::pi * 100e6);
  const double per_depth = kEye.unproject({pixel.x, pixel.y}, 1).norm();
  return 2 + detour / per_depth;
}

TEST(DepthMultipath, IsThePhaseOfTheSumOverWhateverWindow) {
  for (const int radius : {0, 1, 4}) {
    MultipathOptions options = kSent;
    options.radius = radius;
    const RenderedFrame measured = with_multipath(lit_wall_ahead(), kEye, options);
    for (const cv::Point pixel : {cv::Point(12, 8), cv::Point(0, 0), cv::Point(23, 3)}) {
      // What holds slopes that few pixels tell of bends those of a corner's quarter window.
      EXPECT_NEAR(measured.depth(pixel), lengthened_depth(pixel), radius > 0 ? 2e-3 : 1e-6)
          << radius;
      EXPECT_EQ(measured.sight.beyond(pixel), measured.depth(pixel));
    }
    EXPECT_NEAR(measured.depth(8, 12), lengthened_depth({12, 8}), 1e-6) << radius;
  }
}

TEST(DepthMultipath, AveragesNoiseOfOnePlaneAlone) {
  RenderedFrame frame = lit_wall_ahead();
  frame.sight.multipath = cv::Vec2f(0, 0);
  frame.sight.multipath.colRange(12, 24) = cv::Vec2f(0, 0.25F);
  frame.sight.beyond.colRange(12, 24) = 2.5F;  // a step
  const RenderedFrame measured = with_multipath(frame, kEye, kSent);
  EXPECT_EQ(measured.sight.beyond(8, 11), 2);
  EXPECT_NEAR(
      measured.sight.beyond(8, 12) - 2.5,
      0.25 * 3.14159265 * 299792458 / (4 * 3.14159265 * 100e6) / kEye.unproject({12, 8}, 1).norm(),
      1e-5)
      << "an eighth of a turn";
}

TEST(DepthMultipath, LeavesGlassAndMirrorsAndWhatIsNotThere) {
  RenderedFrame frame = lit_wall_ahead();
  frame.sight.first(8, 12) = static_cast<std::uint8_t>(FirstSurface::glass);
  frame.depth(8, 12) = 1;
  frame.depth(9, 12) = 0;
  frame.sight.beyond(9, 12) = 0;
  const RenderedFrame measured = with_multipath(frame, kEye, kSent);
  EXPECT_EQ(measured.depth(8, 12), 1);
  EXPECT_NEAR(measured.sight.beyond(8, 12), lengthened_depth({12, 8}), 1e-4) << "behind the glass";
  EXPECT_EQ(measured.depth(9, 12), 0);
  EXPECT_EQ(frame.depth(7, 12), 2) << "the argument keeps its depth";
  frame.sight.multipath.release();
  EXPECT_EQ(cv::norm(with_multipath(frame, kEye, kSent).depth, frame.depth, cv::NORM_INF), 0);
}

TEST(DepthMultipath, IsLostWhereItIsMoreThanTheCameraTakes) {
  MultipathOptions options = kSent;
  const double detour =
      (lengthened_depth({12, 8}) - 2) * kEye.unproject({12, 8}, 1).norm();  // grows with u
  options.max_error = detour + 1e-4;
  const RenderedFrame measured = with_multipath(lit_wall_ahead(), kEye, options);
  EXPECT_GT(measured.depth(8, 12), 2);
  EXPECT_EQ(measured.normal(8, 12), cv::Vec3f(0, 0, -1));
  EXPECT_EQ(measured.depth(8, 13), 0);
  EXPECT_EQ(measured.normal(8, 13), cv::Vec3f(0, 0, 0));
  EXPECT_EQ(measured.sight.beyond(8, 13), 0);
}

TEST(DepthMultipath, WithoutStraightLightIsThatOfTheOther) {
  RenderedFrame frame = lit_wall_ahead();
  frame.sight.beyond_returned = 0.0F;
  frame.sight.multipath = cv::Vec2f(0, -0.1F);
  const RenderedFrame measured = with_multipath(frame, kEye, kSent);
  EXPECT_NEAR(measured.depth(8, 12),
              2 - 299792458 / (8 * 100e6) / kEye.unproject({12, 8}, 1).norm(), 1e-5)
      << "a quarter of a turn less";
  MultipathOptions slow = kSent;
  slow.frequency = 10e6;
  EXPECT_EQ(with_multipath(frame, kEye, slow).depth(8, 12), 0) << "none before the camera";
}

TEST(DepthMultipath, OfATriangleWithoutAreaIsThatOfItsOwnPixel) {
  RenderedFrame frame = lit_wall_ahead();
  frame.normal = cv::Vec3f(0, 0, 0);
  frame.sight.beyond_normal = cv::Vec3f(0, 0, 0);
  EXPECT_NEAR(with_multipath(frame, kEye, kSent).depth(8, 12), lengthened_depth({12, 8}), 1e-6);
}

}  // namespace
}  // namespace synth
