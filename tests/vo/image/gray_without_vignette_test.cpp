#include "vo/image/gray_without_vignette.h"

#include <gtest/gtest.h>

#include "vo/core/hash.h"

namespace {

/// An image of odd size, and a camera of that size whose centre is off the middle.
struct Scene {
  vo::PinholeCamera camera{.width = 37, .height = 21, .fx = 30, .fy = 30, .cx = 16, .cy = 11};
  vo::ByteImage bytes{21, 37};

  Scene() {
    for (int v = 0; v < bytes.rows; ++v) {
      for (int u = 0; u < bytes.cols; ++u) {
        bytes(v, u) = static_cast<uchar>(vo::mixed(static_cast<std::uint64_t>(v * 37 + u)));
      }
    }
  }
};

TEST(GrayWithoutVignette, IsGrayWithTheVignetteTakenOut) {
  const Scene scene;
  for (const vo::Vignette& vignette :
       {vo::Vignette{}, vo::Vignette{{0.2, 0.05}}, vo::Vignette{{-0.1, 0.3}}}) {
    vo::GrayImage expected = vo::to_gray(scene.bytes);
    vo::take_out(vignette, scene.camera, {}, expected);
    vo::GrayImage gray;
    vo::to_gray_without(vignette, scene.camera, scene.bytes, gray);
    ASSERT_EQ(gray.size(), expected.size());
    EXPECT_EQ(cv::norm(gray, expected, cv::NORM_INF), 0);
  }
}

}  // namespace
