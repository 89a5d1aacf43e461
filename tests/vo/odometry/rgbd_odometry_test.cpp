#include "vo/odometry/rgbd_odometry.h"

#include <map>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/support/image_allocations.h"
#include "tests/support/plane_frames.h"
#include "tests/support/pose_near.h"
#include "vo/core/error.h"
#include "vo/tracking/tracker.h"

namespace {

using support::PoseNear;
using support::small_camera;
using support::sway;
using vo::SE3;
using vo::TrackerPreset;
using vo::TrackingStatus;

vo::RgbdFrame frame_at(const SE3& T_world_camera, int index) {
  return support::plane_frame(small_camera(), T_world_camera, index);
}

/// At 320x240 a pixel is 6 mm wide on the plane; the paper's mask drifts by up to one of them.
TEST(RgbdOdometry, FollowsATexturedPlane) {
  for (const auto& [preset, tolerance_m] :
       {std::pair{TrackerPreset::paper, 6e-3}, std::pair{TrackerPreset::best_measured, 2e-3}}) {
    vo::RgbdOdometry odometry(small_camera(), vo::preset_options(preset), sway(0));
    for (int i = 0; i < 20; ++i) {
      const vo::TrackingResult result = odometry.track(frame_at(sway(i), i));
      EXPECT_EQ(result.status, i == 0 ? TrackingStatus::initialized : TrackingStatus::tracked);
      EXPECT_THAT(result.T_world_camera,
                  PoseNear(sway(i), support::PoseTolerance{.translation_m = tolerance_m,
                                                           .rotation_deg = 50 * tolerance_m}))
          << "frame " << i;
    }
    EXPECT_EQ(odometry.trajectory().size(), 20U);
  }
}

/// The pose that a new keyframe reports is the adjusted one, which the map goes on with.
TEST(RgbdOdometry, FollowsATexturedPlaneWhileItAdjustsItsKeyframes) {
  for (const vo::WindowAdjustment adjust :
       {vo::WindowAdjustment::poses, vo::WindowAdjustment::depth}) {
    vo::TrackerOptions options = vo::preset_options(TrackerPreset::best_measured);
    options.window.adjust = adjust;
    options.keyframes.every = 4;
    vo::RgbdOdometry odometry(small_camera(), options, sway(0));
    for (int i = 0; i < 20; ++i) {
      const vo::TrackingResult result = odometry.track(frame_at(sway(i), i));
      EXPECT_THAT(
          result.T_world_camera,
          PoseNear(sway(i), support::PoseTolerance{.translation_m = 2e-3, .rotation_deg = 0.1}))
          << "frame " << i;
      if (result.is_keyframe) {
        EXPECT_THAT(odometry.tracker().map().last()->T_world_keyframe,
                    PoseNear(result.T_world_camera, support::PoseTolerance{}));
      }
    }
    EXPECT_GE(odometry.tracker().map().keyframes().size(), 3U);
  }
}

/// A pose is as sure as its reference and its alignment to that; the first frame is the origin.
TEST(RgbdOdometry, AbsoluteCovarianceIsCompoundedFromReferenceToReference) {
  vo::TrackerOptions options = vo::preset_options(TrackerPreset::best_measured);
  options.keyframes.every = 4;
  vo::RgbdOdometry odometry(small_camera(), options, sway(3));
  std::map<double, vo::Matrix6d> absolute;
  for (int i = 0; i < 20; ++i) {
    const vo::TrackingResult result = odometry.track(frame_at(sway(3 + i), i));
    if (i == 0) {
      EXPECT_TRUE(result.absolute_covariance.isZero(0));
    } else {
      const vo::Matrix6d Ad = adjoint(result.alignment.T_cur_ref);
      const vo::Matrix6d expected = result.alignment.covariance +
                                    Ad * absolute.at(result.reference_timestamp) * Ad.transpose();
      EXPECT_LT((result.absolute_covariance - expected).norm(), 1e-12 * expected.norm());
    }
    absolute[result.timestamp] = result.absolute_covariance;
  }
}

/// Returns the mean difference of two depths away from the border, m.
double mean_difference(const vo::DepthImage& a, const vo::DepthImage& b) {
  const cv::Rect middle(10, 10, a.cols - 20, a.rows - 20);
  return cv::norm(a(middle), b(middle), cv::NORM_L1) / middle.area();
}

/// A camera in steady motion whose depth is measured 15 ms after the image. Left where it is, depth
/// is off by the 9 mm that the camera goes forwards meanwhile, and by the plane's slope.
TEST(RgbdOdometry, DepthIsMovedToTheTimeOfTheImage) {
  constexpr double kDelay = 0.015;
  const vo::Vector6d velocity = (vo::Vector6d() << 0.3, -0.2, 0.6, 0.3, -0.4, 0.2).finished();
  const auto plane_at = [&](double t) { return frame_at(SE3::exp(t * velocity), 0); };
  vo::RgbdOdometry odometry(small_camera());
  for (int i = 0; i < 8; ++i) {
    vo::RgbdFrame frame = plane_at(i / 30.0);
    const vo::DepthImage exact = frame.depth;
    frame.timestamp = i / 30.0;
    frame.depth = plane_at(i / 30.0 + kDelay).depth;
    frame.depth_delay = kDelay;
    ASSERT_NE(odometry.track(frame).status, TrackingStatus::lost);
    const vo::DepthImage& used = odometry.current().levels.front().depth;
    if (i < 2) {  // the velocity is not known
      EXPECT_EQ(used.data, frame.depth.data);
    } else {
      EXPECT_LT(mean_difference(used, exact), 0.2 * mean_difference(frame.depth, exact));
    }
  }
}

/// Equal stamps, or the option, leave the depth image itself.
TEST(RgbdOdometry, DepthStaysWhereItsTimeIsThatOfTheImage) {
  vo::TrackerOptions options = vo::preset_options(TrackerPreset::best_measured);
  for (const auto& [depth_time, delay] :
       {std::pair{vo::DepthTime::own, 0.0}, std::pair{vo::DepthTime::image, 0.015}}) {
    options.depth_time = depth_time;
    vo::RgbdOdometry odometry(small_camera(), options, sway(0));
    for (int i = 0; i < 4; ++i) {
      vo::RgbdFrame frame = frame_at(sway(i), i);
      frame.depth_delay = delay;
      odometry.track(frame);
      EXPECT_EQ(odometry.current().levels.front().depth.data, frame.depth.data);
    }
  }
}

TEST(RgbdOdometry, AStationaryCameraDoesNotDrift) {
  vo::RgbdOdometry odometry(small_camera());
  for (int i = 0; i < 30; ++i) {
    odometry.track(frame_at(sway(7), i));
  }
  EXPECT_THAT(odometry.trajectory().back().T_world_camera,
              PoseNear(SE3(), support::PoseTolerance{.translation_m = 1e-9}));
}

TEST(RgbdOdometry, TwoRunsGiveTheSameBits) {
  vo::RgbdOdometry first(small_camera());
  vo::RgbdOdometry second(small_camera());
  for (int i = 0; i < 5; ++i) {
    const SE3 a = first.track(frame_at(sway(i), i)).T_world_camera;
    const SE3 b = second.track(frame_at(sway(i), i)).T_world_camera;
    EXPECT_EQ(a.translation(), b.translation());
    EXPECT_EQ(a.rotation().coeffs(), b.rotation().coeffs());
  }
}

/// What a keyframe holds is its own; other images are written where those of the last frame were.
TEST(RgbdOdometry, ImagesTakeNoNewMemoryButAfterAKeyframe) {
  vo::RgbdOdometry odometry(small_camera(), vo::preset_options(TrackerPreset::best_measured));
  bool was_keyframe = true;
  int frames_in_old_memory = 0;
  for (int i = 0; i < 20; ++i) {
    vo::RgbdFrame frame = frame_at(sway(i), i);
    cv::merge(std::vector<cv::Mat>(3, frame.image), frame.image);
    const support::ImageAllocations allocations;
    const vo::TrackingResult result = odometry.track(frame);
    EXPECT_EQ(allocations.bytes() > 0, was_keyframe) << "frame " << i;
    frames_in_old_memory += was_keyframe ? 0 : 1;
    was_keyframe = result.is_keyframe;
  }
  EXPECT_GT(frames_in_old_memory, 5);
}

/// Pairs of images are independent, and their sums are added in order.
TEST(RgbdOdometry, AnyNumberOfThreadsGivesTheSameBits) {
  const auto tracked_by = [](int threads) {
    vo::TrackerOptions options = vo::preset_options(TrackerPreset::best_measured);
    options.align.threads = threads;
    vo::RgbdOdometry odometry(small_camera(), options, sway(0));
    for (int i = 0; i < 20; ++i) {
      odometry.track(frame_at(sway(i), i));
    }
    return odometry.trajectory();
  };
  const int before = cv::getNumThreads();
  cv::setNumThreads(4);
  const vo::Trajectory one = tracked_by(1);
  for (const int threads : {2, 4}) {
    const vo::Trajectory several = tracked_by(threads);
    ASSERT_EQ(several.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(several[i].T_world_camera.translation(), one[i].T_world_camera.translation());
      EXPECT_EQ(several[i].T_world_camera.rotation().coeffs(),
                one[i].T_world_camera.rotation().coeffs());
    }
  }
  cv::setNumThreads(before);
}

TEST(RgbdOdometry, ACoveredLensIsLostAndThenFoundAgain) {
  vo::RgbdOdometry odometry(small_camera(), vo::TrackerOptions(), sway(0));
  odometry.track(frame_at(sway(0), 0));
  odometry.track(frame_at(sway(1), 1));
  for (int i = 2; i < 5; ++i) {
    const vo::TrackingResult lost = odometry.track(support::blank_frame(small_camera(), 90, i));
    EXPECT_EQ(lost.status, TrackingStatus::lost);
    EXPECT_FALSE(lost.is_keyframe);
  }
  const vo::TrackingResult found = odometry.track(frame_at(sway(2), 5));
  EXPECT_EQ(found.status, TrackingStatus::tracked);
  EXPECT_THAT(found.T_world_camera, PoseNear(sway(2), support::PoseTolerance{2e-3, 0.1}));
  EXPECT_EQ(odometry.trajectory().size(), 3U) << "no pose for a lost frame";
}

TEST(RgbdOdometry, AFrameWithoutDepthIsTrackedButIsNoReference) {
  vo::RgbdOdometry odometry(small_camera(), vo::TrackerOptions(), sway(1));
  vo::RgbdFrame dark = frame_at(sway(0), 0);
  dark.depth.setTo(0);
  EXPECT_EQ(odometry.track(dark).status, TrackingStatus::lost) << "nothing to start from";
  EXPECT_EQ(odometry.track(frame_at(sway(1), 1)).status, TrackingStatus::initialized);
  vo::RgbdFrame without_depth = frame_at(sway(2), 2);
  without_depth.depth.setTo(0);
  const vo::TrackingResult result = odometry.track(without_depth);
  EXPECT_EQ(result.status, TrackingStatus::tracked);
  EXPECT_FALSE(result.is_keyframe);
  EXPECT_EQ(odometry.track(frame_at(sway(3), 3)).status, TrackingStatus::tracked);
}

/// Noise, as behind a lens cap, begins a map on which nothing is ever found.
TEST(RgbdOdometry, AMapThatNothingIsFoundOnBeginsAnew) {
  const SE3 T_world_first = sway(3);
  vo::RgbdOdometry odometry(small_camera(), vo::preset_options(TrackerPreset::best_measured),
                            T_world_first);
  const vo::RgbdFrame noise =
      support::with_noise(support::blank_frame(small_camera(), 90, 0), 20, 1);
  EXPECT_EQ(odometry.track(noise).status, TrackingStatus::initialized);
  for (int i = 1; i < 5; ++i) {
    EXPECT_EQ(odometry.track(frame_at(sway(i), i)).status, TrackingStatus::lost) << i;
  }
  const vo::TrackingResult anew = odometry.track(frame_at(sway(5), 5));
  EXPECT_EQ(anew.status, TrackingStatus::initialized);
  EXPECT_TRUE(anew.is_keyframe);
  for (int i = 6; i < 12; ++i) {
    const vo::TrackingResult result = odometry.track(frame_at(sway(i), i));
    EXPECT_EQ(result.status, TrackingStatus::tracked) << i;
    EXPECT_THAT(result.T_world_camera, PoseNear(T_world_first * sway(5).inverse() * sway(i),
                                                support::PoseTolerance{2e-3, 0.1}));
  }
}

/// After one pose that was sure the map is kept: the camera may come back to it.
TEST(RgbdOdometry, AMapThatWasOnceFollowedIsKept) {
  vo::RgbdOdometry odometry(small_camera(), vo::preset_options(TrackerPreset::best_measured));
  odometry.track(frame_at(sway(0), 0));
  ASSERT_EQ(odometry.track(frame_at(sway(1), 1)).status, TrackingStatus::tracked);
  for (int i = 2; i < 40; ++i) {
    const vo::RgbdFrame noise = support::with_noise(support::blank_frame(small_camera(), 90, i), 20,
                                                    static_cast<std::uint64_t>(i));
    EXPECT_NE(odometry.track(noise).status, TrackingStatus::initialized);
  }
  const vo::TrackingResult found = odometry.track(frame_at(sway(2), 40));
  EXPECT_THAT(found.T_world_camera, PoseNear(sway(2), support::PoseTolerance{2e-3, 0.1}));
}

TEST(RgbdOdometry, DepthThatIsMissingInEveryFrameIsNotCalledRepeated) {
  vo::RgbdOdometry odometry(small_camera(), vo::preset_options(TrackerPreset::best_measured));
  odometry.track(frame_at(sway(0), 0));
  for (int i = 1; i < 12; ++i) {
    vo::RgbdFrame frame = frame_at(sway(i), i);
    frame.depth.setTo(0);
    EXPECT_NE(odometry.track(frame).reason, vo::TrackingReason::depth_repeated) << i;
  }
}

TEST(RgbdOdometry, AFrameOfAnotherSizeIsAnError) {
  vo::RgbdOdometry odometry(small_camera());
  EXPECT_THROW(odometry.track({0, vo::ByteImage(240, 320, uchar{0}), {}}), vo::Error);
}

TEST(RgbdOdometry, AnImageThatIsNarrowerThanALookUpIsAnError) {
  for (const auto& [width, height] : {std::pair{200, 3}, {3, 200}}) {
    EXPECT_THROW(vo::RgbdOdometry(vo::PinholeCamera::from_horizontal_fov(width, height, 60)),
                 vo::Error);
  }
}

TEST(RgbdOdometry, ATeleportIsLostNotBelieved) {
  for (const TrackerPreset preset : {TrackerPreset::paper, TrackerPreset::best_measured}) {
    vo::RgbdOdometry odometry(small_camera(), vo::preset_options(preset));
    odometry.track(frame_at(SE3(), 0));
    for (const double metres : {0.9, -1.3, 1.7}) {
      const SE3 far(Eigen::Quaterniond::Identity(), {metres, 0.6 * metres, 0});
      EXPECT_EQ(odometry.track(frame_at(far, 1)).status, TrackingStatus::lost) << metres;
    }
  }
}

TEST(RgbdOdometry, AKeyframeEveryNFrames) {
  vo::TrackerOptions options;
  options.keyframes.every = 3;
  vo::RgbdOdometry odometry(small_camera(), options);
  std::string keyframes;
  for (int i = 0; i < 8; ++i) {
    keyframes += odometry.track(frame_at(sway(i), i)).is_keyframe ? 'K' : '-';
  }
  EXPECT_EQ(keyframes, "K--K--K-");
}

/// Images from other poses never correlate fully; after a loss no less is asked for.
TEST(RgbdOdometry, ALossDoesNotLowerWhatTheOptionsAskFor) {
  vo::TrackerOptions options = vo::preset_options(TrackerPreset::best_measured);
  options.lost.min_correlation = 1;
  vo::RgbdOdometry odometry(small_camera(), options);
  odometry.track(frame_at(sway(0), 0));
  for (int i = 1; i < 4; ++i) {
    EXPECT_EQ(odometry.track(frame_at(sway(i), i)).reason, vo::TrackingReason::images_disagree);
  }
}

/// A pixel a frame, blurred from the second frame on.
int frames_to_a_keyframe(double blur_px) {
  const auto camera = vo::PinholeCamera::from_horizontal_fov(240, 180, 60);
  vo::RgbdOdometry odometry(camera, vo::preset_options(vo::TrackerPreset::best_measured));
  const double step = support::TexturedPlane().point.z() / camera.fx;  // m
  for (int i = 0; i < 60; ++i) {
    const SE3 T_world_camera(Eigen::Quaterniond::Identity(), {i * step, 0, 0});
    vo::RgbdFrame frame = support::plane_frame(camera, T_world_camera, i);
    if (i > 0 && blur_px > 0) {
      cv::GaussianBlur(frame.image, frame.image, {}, blur_px);
    }
    if (odometry.track(frame).is_keyframe && i > 0) {
      return i;
    }
  }
  return 0;
}

/// 6 % of the width are 14.4 px.
TEST(RgbdOdometry, AKeyframeWaitsForASharpImageButNotForever) {
  EXPECT_NEAR(frames_to_a_keyframe(0), 15, 1);
  EXPECT_NEAR(frames_to_a_keyframe(2), 29, 2);
}

/// How far off the last pose is, m, after a sway before a plane, seen through the camera's lens.
double error_through_lens(const vo::PinholeCamera& camera, vo::LensModel lens) {
  vo::TrackerOptions options;
  options.lens = lens;
  vo::RgbdOdometry odometry(camera, options, sway(0));
  for (int i = 0; i < 12; ++i) {
    odometry.track(support::TexturedPlane().render(camera, sway(i), i / 30.0));
  }
  const SE3 last = odometry.trajectory().back().T_world_camera;
  return (last.translation() - sway(11).translation()).norm();
}

/// The lens model makes a distorted camera as good as a perfect one; ignoring it does not.
TEST(RgbdOdometry, TheLensModelCorrectsDistortion) {
  vo::PinholeCamera camera = small_camera();
  camera.distortion = {.k1 = 0.26, .k2 = -0.9, .p1 = -0.005, .p2 = 0.003, .k3 = 1.1};
  const double with_model = error_through_lens(camera, vo::LensModel::distortion);
  EXPECT_LT(with_model, 2e-3);
  EXPECT_GT(error_through_lens(camera, vo::LensModel::ignore), 2 * with_model);
}

TEST(RgbdOdometry, TracksThroughAFisheye) {
  vo::PinholeCamera camera = small_camera();
  camera.distortion = {.k1 = -0.02, .k2 = 0.01, .model = vo::DistortionModel::kannala_brandt};
  const double with_model = error_through_lens(camera, vo::LensModel::distortion);
  EXPECT_LT(with_model, 2e-3);
  EXPECT_GT(error_through_lens(camera, vo::LensModel::ignore), 2 * with_model);
}

TEST(RgbdOdometry, IsTheBestPresetWithoutOptions) {
  vo::RgbdOdometry plain(small_camera());
  vo::RgbdOdometry best(small_camera(), vo::preset_options(TrackerPreset::best_measured));
  for (int i = 0; i < 4; ++i) {
    const vo::TrackingResult a = plain.track(frame_at(sway(i), i));
    const vo::TrackingResult b = best.track(frame_at(sway(i), i));
    EXPECT_EQ(a.T_world_camera.translation(), b.T_world_camera.translation());
    EXPECT_EQ(a.alignment.iterations, b.alignment.iterations);
  }
}

}  // namespace
