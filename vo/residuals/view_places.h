#pragma once

#include <array>
#include <cstddef>

#include "vo/residuals/point_block.h"

namespace vo {

/// The pixels of a view at which at most 64 points lie. Points out of view have u = v = kNowhere;
/// to be in view is less than to be seen (`SeenBounds`).
struct alignas(64) ViewPlaces {
  static constexpr std::size_t kMost = detail::kBlock;
  static constexpr float kNowhere = -1;

  std::array<float, kMost> u, v;  ///< px
  std::array<float, kMost> z;     ///< m, in the camera's frame

  bool is_in_view(std::size_t i) const { return u[i] > kNowhere; }
};

/// Some points, m: one array for each coordinate.
struct PointArrays {
  const float* x;
  const float* y;
  const float* z;
  std::size_t count;
};

/// Finds where points of one frame are in the view of another, many at a time.
class ViewPlacer {
 public:
  ViewPlacer(const PinholeCamera& camera, const SE3& T_cur_ref);

  /// Places at most ViewPlaces::kMost points. Others of `places` keep their values.
  void place(const PointArrays& points, ViewPlaces& places) const;

 private:
  detail::PassWarp warp_;
  float max_u_, max_v_;  ///< px, where the image ends
};

}  // namespace vo
