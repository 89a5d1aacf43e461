#include "vo/bootstrap/mono_initialiser.h"

#include <functional>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/plane_map.h"
#include "tests/support/pose_near.h"
#include "vo/core/random_field.h"

namespace {

using support::grey_frame;
using support::small_camera;
using vo::InitialiserVerdict;
using vo::SE3;

/// 1.5 cm a frame past the plane at 2 m: about 2 px.
SE3 walk(double frame) {
  return SE3::exp((vo::Vector6d() << 0.015 * frame, 0.005 * frame, 0.004 * frame, 0, 0.002 * frame,
                   0.001 * frame)
                      .finished());
}

TEST(CornerTracks, FollowPlacesOfThePlane) {
  const vo::PinholeCamera camera = small_camera();
  vo::CornerTracks tracks(grey_frame(camera, SE3()), 200);
  ASSERT_GT(tracks.size(), 80U);
  for (int i = 1; i <= 5; ++i) {
    tracks.follow(grey_frame(camera, walk(i)));
  }
  ASSERT_GT(tracks.alive(), tracks.size() * 7 / 10);
  std::size_t right = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const double z = support::TexturedPlane().depth(camera, SE3(), tracks.start(i));
    const Eigen::Vector2d truth =
        camera.project(walk(5).inverse() * camera.unproject(tracks.start(i), z));
    right += tracks.is_alive(i) && (tracks.now(i) - truth).norm() < 0.3 ? 1 : 0;
  }
  EXPECT_GT(right, tracks.alive() * 9 / 10);
}

/// The plane as it is seen after `frame` frames of the walk, its grey values changed.
vo::FramePyramid changed_frame(double frame, const std::function<void(cv::Mat_<float>&)>& change) {
  vo::FramePyramid pyramid = grey_frame(small_camera(), walk(frame));
  for (vo::PyramidLevel& level : pyramid.levels) {
    change(level.intensity);
  }
  return pyramid;
}

std::size_t alive_after(const vo::FramePyramid& second) {
  vo::CornerTracks tracks(grey_frame(small_camera(), SE3()), 200);
  tracks.follow(second);
  return tracks.alive() * 100 / tracks.size();
}

TEST(CornerTracks, FollowThroughBlurAndAnotherExposure) {
  const auto share = alive_after(changed_frame(1, [](cv::Mat_<float>& image) {
    cv::GaussianBlur(image, image, {}, 1.5);
    image = 0.6 * image + 0.1;
  }));
  EXPECT_GT(share, 80U) << "percent";
}

TEST(CornerTracks, LoseWhatIsNotThereAnyMore) {
  const auto share = alive_after(changed_frame(1, [](cv::Mat_<float>& image) {
    const vo::RandomField noise(7, 1, 2);
    image.forEach([&](float& value, const int* place) {
      value = static_cast<float>(noise.uniform(place[1], place[0]));
    });
    cv::GaussianBlur(image, image, {}, 1);
  }));
  EXPECT_LT(share, 5U) << "percent";
  EXPECT_EQ(alive_after(changed_frame(1, [](cv::Mat_<float>& image) { image = 0.5; })), 0U);
}

TEST(MonoInitialiser, FindsPosesAndDepthsOfAnUnknownPlane) {
  vo::MonoInitialiser initialiser(grey_frame(small_camera(), walk(0)), {6, 6}, 2);
  vo::InitialiserReport report;
  int frame = 0;
  while (report.verdict != InitialiserVerdict::solved && frame < 30) {
    report = initialiser.add(grey_frame(small_camera(), walk(++frame)));
  }
  ASSERT_EQ(report.verdict, InitialiserVerdict::solved);
  EXPECT_GE(report.parallax_px, 6);
  const auto& frames = initialiser.frames();
  const double scale =
      walk(frame).translation().norm() / frames.back().T_frame_first.translation().norm();
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const SE3& T = frames[i].T_frame_first;
    const SE3 T_metric(T.rotation(), scale * T.translation());
    EXPECT_THAT(T_metric.inverse(), support::PoseNear(walk(static_cast<int>(i)),
                                                      support::PoseTolerance{.translation_m = 0.02,
                                                                             .rotation_deg = 0.6}))
        << "frame " << i;
  }
}

/// Parallax when it is solved, on a walk that is slow enough to choose.
double parallax_at_start(const vo::StartParallax& parallax) {
  vo::MonoInitialiser initialiser(grey_frame(small_camera(), walk(0)), parallax, 2);
  vo::InitialiserReport report;
  for (int i = 1; i < 60 && report.verdict != InitialiserVerdict::solved; ++i) {
    report = initialiser.add(grey_frame(small_camera(), walk(0.3 * i)));
  }
  return report.verdict == InitialiserVerdict::solved ? report.parallax_px : 0;
}

TEST(MonoInitialiser, WaitsForMoreParallaxWhileCornersAreInView) {
  constexpr double kOutOfReach = 1000;  // px
  const double hasty = parallax_at_start({2, 2});
  EXPECT_GE(hasty, 2);
  EXPECT_GT(parallax_at_start({2, 5}), 1.3 * hasty);
  EXPECT_GE(parallax_at_start({2, kOutOfReach}), 2) << "it does not wait until nothing is left";
}

/// The camera flies down to the plane at a slant, so that it may as well see another plane.
SE3 descent(double frame) {
  const SE3 slanted = SE3::exp((vo::Vector6d() << 0, 1.5, 0.4, 0.6, 0, 0).finished());
  return slanted * SE3::exp((vo::Vector6d() << 0.008 * frame, -0.002 * frame, 0.02 * frame, 0,
                             0.001 * frame, 0.002 * frame)
                                .finished());
}

TEST(MonoInitialiser, TwoFramesOfAPlaneAreAmbiguousAndMoreAreNot) {
  constexpr int kLast = 24;
  const SE3 T_first_last = descent(0).inverse() * descent(kLast);
  vo::MonoInitialiser two(grey_frame(small_camera(), descent(0)), {2, 2}, 2);
  EXPECT_EQ(two.add(grey_frame(small_camera(), descent(kLast / 4))).verdict,
            InitialiserVerdict::ambiguous);

  constexpr double kUntilFinish = 1000;  // px
  vo::MonoInitialiser all(grey_frame(small_camera(), descent(0)), {2, kUntilFinish}, 2);
  for (int i = 1; i <= kLast; ++i) {
    all.add(grey_frame(small_camera(), descent(i)));
  }
  ASSERT_EQ(all.finish().verdict, InitialiserVerdict::solved);
  const Eigen::Vector3d found = all.frames().back().T_frame_first.inverse().translation();
  EXPECT_GT(found.normalized().dot(T_first_last.translation().normalized()), 0.995);
}

TEST(MonoInitialiser, RecognisesATurn) {
  vo::MonoInitialiser initialiser(grey_frame(small_camera(), SE3()), {6, 6}, 2);
  vo::InitialiserReport report;
  for (int i = 1; i <= 12; ++i) {
    const SE3 turn = SE3::exp((vo::Vector6d() << 0, 0, 0, 0.002 * i, 0.008 * i, 0).finished());
    report = initialiser.add(grey_frame(small_camera(), turn));
    EXPECT_NE(report.verdict, InitialiserVerdict::solved);
  }
  EXPECT_EQ(report.verdict, InitialiserVerdict::pure_rotation);
}

}  // namespace
