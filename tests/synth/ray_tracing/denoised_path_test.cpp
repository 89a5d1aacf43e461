#include <cstring>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "tests/support/lit_box.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using support::lit_box;
using support::relative_error;

vo::PinholeCamera small_camera() {
  return vo::PinholeCamera::from_horizontal_fov(33, 25, 90);
}

cv::Mat_<cv::Vec3f> radiance(const Scene& scene, const RenderOptions& options) {
  return render(scene, options, small_camera()).radiance;
}

RenderOptions path_options(int samples, bool denoise) {
  return {
      .mode = RenderMode::path, .samples = samples, .ambient = 0, .bounces = 4, .denoise = denoise};
}

TEST(DenoisedPath, HasAThirdOfTheErrorAt16SamplesAndTheSameBrightness) {
  const Scene scene = lit_box();
  const cv::Mat_<cv::Vec3f> truth = radiance(scene, path_options(1024, false));
  const cv::Mat_<cv::Vec3f> clean = radiance(scene, path_options(16, true));
  const double error = relative_error(clean, truth);
  EXPECT_LT(3 * error, relative_error(radiance(scene, path_options(16, false)), truth));
  EXPECT_NEAR(cv::mean(clean)[1], cv::mean(truth)[1], 0.02 * cv::mean(truth)[1]);
  EXPECT_LT(relative_error(radiance(scene, path_options(144, true)), truth), 0.7 * error);
}

TEST(DenoisedPath, LightOfPointsIsThatWithoutDenoising) {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({1, 1, 1}));
  add(scene, quad({0, -4, -1}, {4, 0, 0}, {0, 8, 0}), diffuse({0, 0, 0}));
  scene.lights.push_back(point_light({0, 0, -2}, {100, 100, 100}));
  RenderOptions options = path_options(16, true);
  options.bounces = 0;
  const cv::Mat_<cv::Vec3f> clean = radiance(scene, options);
  options.denoise = false;
  EXPECT_EQ(cv::norm(clean, radiance(scene, options), cv::NORM_INF), 0);
}

TEST(DenoisedPath, OfAMovingCameraIsAsSharpAsItsMotionSays) {
  const Scene scene = lit_box();
  Capture capture = still(small_camera(), {});
  capture.motion = [](double time) {
    return vo::SE3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(5 * time, 0, 0));
  };
  capture.shutter = {.exposure_time = 0.04, .readout_time = 0.03};
  const auto render_moving = [&](const RenderOptions& options) {
    return make_renderer(scene, options)->render(capture).radiance;
  };
  const cv::Mat_<cv::Vec3f> truth = render_moving(path_options(1024, false));
  EXPECT_LT(relative_error(render_moving(path_options(16, true)), truth),
            0.7 * relative_error(render_moving(path_options(16, false)), truth));
}

TEST(DenoisedPath, IsTheSameEachTime) {
  const Scene scene = lit_box();
  const cv::Mat_<cv::Vec3f> once = radiance(scene, path_options(9, true));
  const cv::Mat_<cv::Vec3f> again = radiance(scene, path_options(9, true));
  EXPECT_EQ(std::memcmp(once.data, again.data, once.total() * once.elemSize()), 0);
}

}  // namespace
}  // namespace synth
