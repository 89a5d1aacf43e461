#include <vector>

#include <gtest/gtest.h>

#ifdef EDVO_HAS_CALIB3D
#include <opencv2/calib3d.hpp>
#endif

#include "vo/dataset/camera_file.h"
#include "vo/geometry/camera.h"

namespace {

/// Cameras of each lens model: five coefficients, eight (an Azure Kinect's, as its SDK gives them),
/// a mild rational one, and fisheyes.
std::vector<vo::PinholeCamera> cameras_of_all_models() {
  using vo::DistortionModel;
  return {vo::load_camera("tum-fr1").pinhole,
          {2048,
           1536,
           975.9,
           975.6,
           1021.6,
           780.2,
           {0.47516, -2.5563, 7.27e-4, -2.9e-4, 1.45127, 0.35689, -2.38113, 1.38187}},
          {640, 480, 400, 410, 320, 240, {-0.2, 0.05, 0.001, -0.002, 0.01, 0.1, 0.02, -0.003}},
          {512,
           512,
           190.98,
           190.97,
           254.93,
           256.9,
           {.k1 = 0.00348,
            .k2 = 0.00072,
            .k3 = -0.00205,
            .k4 = 0.0002,
            .model = DistortionModel::kannala_brandt}},
          {640,
           480,
           280,
           281,
           321,
           238,
           {.k1 = -0.013,
            .k2 = 0.021,
            .k3 = -0.012,
            .k4 = 0.0021,
            .model = DistortionModel::kannala_brandt}}};
}

TEST(LensMatchesOpenCV, EveryDirectionIsImagedInTheSamePixel) {
#ifdef EDVO_HAS_CALIB3D
  for (const vo::PinholeCamera& camera : cameras_of_all_models()) {
    camera.validate();
    const vo::Distortion& lens = camera.distortion;
    const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    std::vector<cv::Point3d> points;
    for (int v = 0; v < camera.height; v += camera.height / 12) {
      for (int u = 0; u < camera.width; u += camera.width / 12) {
        const Eigen::Vector3d point = camera.unproject({u, v}, 1.7);
        if (point.allFinite()) {
          points.emplace_back(point.x(), point.y(), point.z());
        }
      }
    }
    std::vector<cv::Point2d> pixels;
    const cv::Vec3d none(0, 0, 0);
    if (lens.model == vo::DistortionModel::kannala_brandt) {
      cv::fisheye::projectPoints(points, pixels, none, none, K,
                                 cv::Vec4d(lens.k1, lens.k2, lens.k3, lens.k4));
    } else {
      cv::projectPoints(points, none, none, K,
                        std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, lens.k4,
                                            lens.k5, lens.k6},
                        pixels);
    }
    ASSERT_GT(points.size(), 100U);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d pixel = camera.project({points[i].x, points[i].y, points[i].z});
      EXPECT_LT((pixel - Eigen::Vector2d(pixels[i].x, pixels[i].y)).norm(), 1e-8) << "px";
    }
  }
#else
  GTEST_SKIP() << "libopencv-calib3d-dev is not installed";
#endif
}

}  // namespace
