#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "synth/camera/make_renderer.h"
#include "synth/gltf/scene_file.h"
#include "synth/truth/motion_truth.h"
#include "synth/truth/stereo_truth.h"
#include "tests/cross/stereo/opencv_matcher.h"

namespace synth {
namespace {

constexpr double kBaseline = 0.1;  // m

#ifdef EDVO_HAS_CALIB3D

cv::Mat_<std::uint8_t> grey_picture(const Renderer& renderer, const vo::PinholeCamera& camera,
                                    const vo::SE3& T_world_camera) {
  cv::Mat_<float> grey;
  cv::cvtColor(renderer.render(camera, T_world_camera).radiance, grey, cv::COLOR_RGB2GRAY);
  cv::Mat_<float> brightness;
  cv::pow(cv::min(grey, 1), 1 / 2.2, brightness);
  cv::Mat_<std::uint8_t> picture;
  brightness.convertTo(picture, CV_8U, 255);
  return picture;
}

/// Returns where the image has texture along its rows.
cv::Mat_<std::uint8_t> textured(const cv::Mat_<std::uint8_t>& picture) {
  constexpr double kLeastGradient = 40;  // of Sobel's operator, 8 times the grey levels per px
  cv::Mat_<float> gradient;
  cv::Sobel(picture, gradient, CV_32F, 1, 0);
  const cv::Mat result = cv::abs(gradient) > kLeastGradient;
  return result;
}

TEST(Disparity, IsWhatOpencvsMatcherFindsInPicturesOfTheDesk) {
  const SceneFile file(EDVO_SOURCE_DIR "/assets/desk/desk.gltf");
  const Scene& scene = file.scene();
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(320, 240, 60);
  const vo::SE3 T_world_left = vo::look_at({0.2, 1.5, 1.3}, {0, 0.8, 0}, {0, 1, 0});
  const vo::SE3 T_world_right = T_world_left * T_left_right(kBaseline);
  const auto renderer = make_renderer(scene, {.mode = RenderMode::unlit, .samples = 8});
  const cv::Mat_<std::uint8_t> left = grey_picture(*renderer, camera, T_world_left);
  const cv::Mat_<float> found =
      support::matched(left, grey_picture(*renderer, camera, T_world_right));
  const PointTracer tracer(scene);
  const PointImage points = tracer.trace(camera, T_world_left);
  const cv::Mat_<float> exact = disparity_truth(points, camera.fx * kBaseline);
  const cv::Mat_<std::uint8_t> fates = occlusion(points, {tracer, camera, T_world_right});
  const cv::Mat_<std::uint8_t> has_texture = textured(left);
  std::vector<double> errors;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = support::kDisparities; u < camera.width; ++u) {
      if (found(v, u) >= 0 && has_texture(v, u) != 0 && fates(v, u) == 0) {
        errors.push_back(std::abs(found(v, u) - exact(v, u)));
      }
    }
  }
  ASSERT_GT(errors.size(), 3000U);
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  const auto wrong = std::count_if(errors.begin(), errors.end(), [](double e) { return e > 1; });
  std::cout << "median error " << *middle << " px, " << wrong << " of " << errors.size()
            << " beyond 1 px\n";
  EXPECT_LT(*middle, 0.25);
  EXPECT_LT(static_cast<double>(wrong), 0.15 * static_cast<double>(errors.size()));
}

#endif

}  // namespace
}  // namespace synth
