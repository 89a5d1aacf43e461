#include "vo/residuals/view_places.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "vo/core/hash.h"
#include "vo/dataset/camera_file.h"
#include "vo/residuals/warp.h"

namespace {

TEST(ViewPlaces, AreThoseOfSinglePoints) {
  const vo::PinholeCamera camera = vo::load_camera("tum-fr1").pinhole;
  const vo::SE3 T_cur_ref =
      vo::SE3::exp((vo::Vector6d() << 0.3, -0.2, -0.4, 0.1, 0.2, -0.3).finished());
  constexpr std::size_t kPoints = 50;
  std::vector<float> x, y, z;
  for (std::size_t i = 0; i < kPoints; ++i) {
    z.push_back(static_cast<float>(2 * vo::random_uniform({i, 0})));
    x.push_back(z.back() * static_cast<float>(1.6 * vo::random_uniform({i, 1}) - 0.8));
    y.push_back(z.back() * static_cast<float>(1.2 * vo::random_uniform({i, 2}) - 0.6));
  }
  vo::ViewPlaces places;
  vo::ViewPlacer(camera, T_cur_ref).place({x.data(), y.data(), z.data(), kPoints}, places);
  const vo::Warp<double> warp(camera, T_cur_ref);
  std::size_t in_view = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const vo::WarpedPoint<double> point = vo::warp_point<double>(warp, {x[i], y[i], z[i]});
    ASSERT_EQ(places.is_in_view(i), vo::is_in_view(point, camera)) << i;
    EXPECT_NEAR(places.z[i], point.p_cur.z(), 1e-6);
    if (places.is_in_view(i)) {
      EXPECT_NEAR(places.u[i], point.u, 1e-3);
      EXPECT_NEAR(places.v[i], point.v, 1e-3);
      ++in_view;
    }
  }
  EXPECT_GT(in_view, kPoints / 10);
  EXPECT_LT(in_view, kPoints);
}

}  // namespace
