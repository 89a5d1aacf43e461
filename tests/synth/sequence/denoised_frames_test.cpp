#include "synth/sequence/denoised_frames.h"

#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "synth/camera/make_renderer.h"
#include "tests/support/lit_box.h"

namespace synth {
namespace {

using support::lit_box;
using support::relative_error;
using Image = cv::Mat_<cv::Vec3f>;

constexpr std::size_t kFrames = 4;
constexpr std::size_t kFrame = 1;  // which is looked at

vo::PinholeCamera small_camera() {
  return vo::PinholeCamera::from_horizontal_fov(40, 30, 90);
}

RenderOptions path_options(int samples, bool denoise) {
  return {.mode = RenderMode::path, .samples = samples, .ambient = 0, .denoise = denoise};
}

/// A camera that moves past the box; each frame has samples of its own.
Capture passing(std::size_t index) {
  Capture capture = still(small_camera(), {});
  capture.motion = [place = 0.02 * static_cast<double>(index)](double time) {
    return vo::SE3(Eigen::Quaterniond(Eigen::AngleAxisd(place + time, Eigen::Vector3d::UnitY())),
                   Eigen::Vector3d(place + time, 0.5 * place, -place));
  };
  capture.seed = 100 + index;
  return capture;
}

/// A frame source whose scenes and captures are functions of the frame's index.
class Frames {
 public:
  Frames(const std::function<Scene(std::size_t)>& scene_of,
         std::function<Capture(std::size_t)> capture, int samples)
      : capture_(std::move(capture)) {
    for (std::size_t i = 0; i < kFrames; ++i) {
      scenes_[i] = scene_of(i);
      renderers_[i] = make_renderer(scenes_[i], path_options(samples, true));
    }
  }

  FrameSource source() const {
    return {kFrames, capture_, [this](std::size_t index) { return renderers_[index]; }};
  }

  Image by_itself(std::size_t index) const {
    return renderers_[index]->render(capture_(index)).radiance;
  }

  /// A frame of so many samples that the denoiser leaves them nearly as they are.
  Image truth(std::size_t index) const {
    return make_renderer(scenes_[index], path_options(400, true))->render(capture_(index)).radiance;
  }

 private:
  std::array<Scene, kFrames> scenes_;
  std::array<std::shared_ptr<const Renderer>, kFrames> renderers_;
  std::function<Capture(std::size_t)> capture_;
};

Image denoised_frame(const Frames& frames, std::size_t index, int reach = 2) {
  return DenoisedFrames(frames.source(), reach).render(index).rendered.radiance;
}

bool is_same_image(const Image& a, const Image& b) {
  return cv::norm(a, b, cv::NORM_INF) == 0;
}

Scene box_at_rest(std::size_t /*index*/) {
  return lit_box();
}

/// Returns the error of a frame with the light of others over its error by itself.
double error_over_alone(const Frames& frames) {
  const Image truth = frames.truth(kFrame);
  return relative_error(denoised_frame(frames, kFrame), truth) /
         relative_error(frames.by_itself(kFrame), truth);
}

TEST(DenoisedFrames, HaveLessNoiseThanEachByItself) {
  const Frames frames(box_at_rest, passing, 9);
  EXPECT_LT(error_over_alone(frames), 0.8);
}

TEST(DenoisedFrames, OfARollingShutterAndAnExposureAreAsSharpAsTheirMotionSays) {
  const auto capture_of = [](std::size_t index) {
    Capture capture = passing(index);
    capture.shutter = {.exposure_time = 0.02, .readout_time = 0.02};
    return capture;
  };
  const Frames frames(box_at_rest, capture_of, 9);
  EXPECT_LT(error_over_alone(frames), 0.8);
}

TEST(DenoisedFrames, FollowThingsThatMove) {
  const auto box_with_a_slab = [](std::size_t index) {
    Scene scene = lit_box();
    const float x = -0.7F + 0.03F * static_cast<float>(index);
    add(scene, quad({x, -0.4F, 0.5F}, {0.8F, 0, 0}, {0, 0.8F, 0}), diffuse({0.9F, 0.9F, 0.9F}));
    return scene;
  };
  const auto at_rest = [](std::size_t index) {
    Capture capture = still(small_camera(), {});
    capture.seed = 100 + index;
    return capture;
  };
  const Frames frames(box_with_a_slab, at_rest, 9);
  EXPECT_LT(error_over_alone(frames), 0.9);
}

TEST(DenoisedFrames, DoNotSmearLightThatChanges) {
  const auto flickering = [](std::size_t index) {
    return lit_box(index == kFrame ? 10.0F : 20.0F);
  };
  const Frames frames(flickering, passing, 64);
  const Image truth = frames.truth(kFrame);
  const Image result = denoised_frame(frames, kFrame);
  EXPECT_LT(relative_error(result, truth), 1.1 * relative_error(frames.by_itself(kFrame), truth));
  EXPECT_NEAR(cv::mean(result)[1], cv::mean(truth)[1], 0.02 * cv::mean(truth)[1]);
}

TEST(DenoisedFrames, WithoutOthersAreThoseOfTheRenderer) {
  const Frames frames(box_at_rest, passing, 9);
  EXPECT_LT(cv::norm(denoised_frame(frames, 1, 0), frames.by_itself(1), cv::NORM_INF), 1e-4);
}

TEST(DenoisedFrames, DependOnTheirIndexAlone) {
  const Frames frames(box_at_rest, passing, 4);
  const DenoisedFrames in_order(frames.source(), 1);
  const DenoisedFrames at_once(frames.source(), 1);
  const DenoisedFrames forgetful(frames.source(), 1, 1);
  std::array<Image, kFrames> expected;
  for (std::size_t i = 0; i < kFrames; ++i) {
    expected[i] = in_order.render(i).rendered.radiance;
  }
  std::array<Image, kFrames> images;
  tbb::parallel_for(std::size_t{0}, kFrames,
                    [&](std::size_t i) { images[i] = at_once.render(i).rendered.radiance; });
  for (std::size_t i = 0; i < kFrames; ++i) {
    EXPECT_TRUE(is_same_image(images[i], expected[i])) << i;
    EXPECT_TRUE(is_same_image(denoised_frame(frames, i, 1), expected[i])) << i;
    EXPECT_TRUE(is_same_image(forgetful.render(i).rendered.radiance, expected[i])) << i;
  }
}

}  // namespace
}  // namespace synth
