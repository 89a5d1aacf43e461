#include "vo/residuals/view_agreement.h"

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"

namespace {

using support::plane_frame;
using support::small_camera;
using support::sway;

vo::FramePyramid pyramid_of(const vo::RgbdFrame& frame) {
  vo::FramePyramid pyramid = vo::build_pyramid(frame, small_camera(), {});
  vo::add_edges(pyramid, vo::EdgeOptions());
  return pyramid;
}

/// Compares the first frame's points with a frame's image at the true pose, in a model of its own.
vo::ViewAgreement agreement_with(const vo::RgbdFrame& frame, const vo::ResidualModel& model) {
  const vo::FramePyramid reference = pyramid_of(plane_frame(small_camera(), sway(0), 0));
  const vo::FramePyramid current = pyramid_of(frame);
  const vo::EdgePoints points = vo::edge_points(reference, current, {});
  const vo::PointView view{
      points.levels[0], current.levels[0], sway(3).inverse() * sway(0), {}, {}};
  vo::PointTerms terms;
  vo::compute_point_terms(view, {}, model, terms);
  return vo::view_agreement(view, terms, model);
}

constexpr vo::ResidualModel kSame{.scale = 0.02, .brightness = {}};

TEST(ViewAgreement, IsWholeWhereAllIsRigidWhateverTheBrightness) {
  vo::RgbdFrame frame = plane_frame(small_camera(), sway(3), 3);
  EXPECT_TRUE(agreement_with(frame, kSame).disagreeing.none());
  EXPECT_GT(agreement_with(frame, kSame).agreeing_correlation, 0.99);
  cv::Mat dimmed;
  frame.image.convertTo(dimmed, -1, 0.5, 30);
  frame.image = dimmed;
  const vo::ViewAgreement dim =
      agreement_with(frame, {.scale = 0.02, .brightness = {.gain = 0.5, .offset = 30.0 / 255}});
  EXPECT_EQ(dim.disagreeing_fraction, 0);
  EXPECT_GT(dim.agreeing_correlation, 0.99);
}

/// The left half of the image shows the plane from elsewhere: 4 of 8 columns of cells.
TEST(ViewAgreement, NamesThePartThatShowsSomethingElse) {
  vo::RgbdFrame frame = plane_frame(small_camera(), sway(3), 3);
  const vo::SE3 elsewhere(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.4, 0.3, 0));
  const int half = small_camera().width / 2;
  frame.image = frame.image.clone();
  plane_frame(small_camera(), elsewhere, 3)
      .image.colRange(0, half)
      .copyTo(frame.image.colRange(0, half));
  const vo::ViewAgreement found = agreement_with(frame, kSame);
  EXPECT_NEAR(found.disagreeing_fraction, 0.5, 0.15);
  EXPECT_GT(found.agreeing_correlation, 0.9);
  for (int row = 0; row < vo::ViewCells::kRows; ++row) {
    for (int column = 4; column < vo::ViewCells::kColumns; ++column) {
      const auto cell = static_cast<std::size_t>(row * vo::ViewCells::kColumns + column);
      EXPECT_FALSE(found.disagreeing[cell]) << row << ", " << column;
    }
  }
}

}  // namespace
