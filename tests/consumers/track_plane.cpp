// Tracks a camera that moves 2 mm a frame to the right in front of a striped wall 2 m away, and
// compares the estimate with that. A program of a project that uses edvo's tracking and evaluation
// libraries.
#include <cmath>
#include <cstdio>

#include <opencv2/core.hpp>

#include "vo/core/version.h"
#include "vo/evaluation/evaluate.h"
#include "vo/odometry/rgbd_odometry.h"

namespace {

constexpr double kDepth = 2;     // m
constexpr double kStep = 0.002;  // m, from frame to frame
constexpr int kFrames = 6;

/// The grey of the wall at a point, m: stripes of two directions, whose edges span some pixels.
double wall(double x, double y) {
  return 120 + 50 * std::tanh(3 * std::sin(13 * x + 7 * y)) +
         40 * std::tanh(3 * std::sin(11 * y - 9 * x));
}

vo::RgbdFrame frame_at(const vo::PinholeCamera& camera, int index) {
  vo::ByteImage image(camera.height, camera.width);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d p_camera = camera.unproject({u, v}, kDepth);
      image(v, u) = cv::saturate_cast<uchar>(wall(p_camera.x() + index * kStep, p_camera.y()));
    }
  }
  return {index / 30.0, image, vo::DepthImage(image.size(), static_cast<float>(kDepth))};
}

}  // namespace

int main() {
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(320, 240, 60);
  vo::RgbdOdometry odometry(camera);
  vo::Trajectory truth;
  for (int i = 0; i < kFrames; ++i) {
    const vo::RgbdFrame frame = frame_at(camera, i);
    truth.push_back({frame.timestamp, {Eigen::Quaterniond::Identity(), {i * kStep, 0, 0}}});
    odometry.track(frame);
  }
  const vo::Trajectory& estimate = odometry.trajectory();
  const double ate = vo::evaluate(truth, estimate).ate.rmse;
  std::printf("edvo %s: %zu of %d frames tracked, ATE %.6f m\n", vo::version(), estimate.size(),
              kFrames, ate);
  return estimate.size() == kFrames && ate < 0.0005 ? 0 : 1;
}
