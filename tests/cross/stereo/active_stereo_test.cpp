#include <cmath>
#include <iostream>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "synth/camera/renderers_over_time.h"
#include "synth/camera/sequence_camera.h"
#include "synth/rig/camera_jobs.h"
#include "tests/cross/stereo/opencv_matcher.h"
#include "tests/support/quads.h"
#include "vo/rigs/rig_file.h"

namespace synth {
namespace {

#ifdef EDVO_HAS_CALIB3D

/// A white wall without texture, z = 1.5 + 0.2 x, and a lamp.
Scene blank_wall() {
  Scene scene;
  add(scene, quad({-3, -3, 0.9F}, {6, 0, 1.2F}, {0, 6, 0}), diffuse({0.8F, 0.8F, 0.8F}));
  scene.lights.push_back(point_light({0.5, -1, 0}, {4, 4, 4}));
  return scene;
}

/// Returns the image that a camera of a rig takes, cut to the middle of its view.
cv::Mat_<std::uint8_t> picture_of(const Scene& scene, const RenderJob& job) {
  const RenderersOverTime renderers(scene, {.samples = 16});
  const CameraTruth motion{job.recipe.truth, job.recipe.path};
  const SequenceCamera camera(scene, renderers, job.recipe.camera.model, motion, job.recipe.sensor,
                              job.recipe.infrared);
  cv::Mat_<std::uint8_t> picture;
  cv::extractChannel(camera.take(0).image, picture, 1);
  return picture;
}

/// Returns the share of a picture's pixels, but for those that the matcher cannot know, at which it
/// finds the true disparity within half a pixel.
double found_share(const RenderJob& left, const RenderJob& right, double baseline) {
  const Scene scene = blank_wall();
  const cv::Mat_<float> found = support::matched(picture_of(scene, left), picture_of(scene, right));
  const vo::PinholeCamera& camera = *left.recipe.camera.model.pinhole();
  int right_ones = 0;
  int all = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = support::kDisparities; u < camera.width; ++u) {
      const Eigen::Vector3d ray = camera.unproject(Eigen::Vector2d(u, v), 1);
      const double depth = 1.5 / (1 - 0.2 * ray.x());
      right_ones += std::abs(found(v, u) - camera.fx * baseline / depth) < 0.5 ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(right_ones) / all;
}

TEST(ActiveStereo, OpencvsMatcherMeasuresABlankWallByTheProjectorsDotsAlone) {
  RigJob rig{vo::read_rig(EDVO_SOURCE_DIR "/assets/rigs/active_stereo.toml"), {}};
  for (vo::RigCamera& camera : rig.rig.cameras) {  // the middle of their views
    const vo::PinholeCamera& whole = *camera.camera.model.pinhole();
    camera.camera.model = vo::PinholeCamera{
        .width = 300, .height = 120, .fx = whole.fx, .fy = whole.fy, .cx = 149.5, .cy = 59.5};
  }
  rig.body.recipe.truth = {{0, {}}};
  rig.body.recipe.path = [](double) { return vo::SE3(); };
  const std::vector<RenderJob> jobs = camera_jobs(rig);
  const double baseline = vo::stereo_baseline(rig.rig, rig.rig.cameras[1]);
  const double with = found_share(jobs[1], jobs[2], baseline);
  rig.rig.projectors.clear();
  const std::vector<RenderJob> dark = camera_jobs(rig);
  const double without = found_share(dark[1], dark[2], baseline);
  std::cout << "within 0.5 px: " << 100 * with << " % with the projector, " << 100 * without
            << " % without\n";
  EXPECT_GT(with, 0.9);
  EXPECT_LT(without, 0.2);
}

#endif

}  // namespace
}  // namespace synth
