#include "vo/residuals/view_places.h"

#include "vo/core/instruction_set.h"

namespace vo {
namespace {

using detail::PassWarp;

/// A pose and a camera, and where its image ends, px.
struct PlacerWarp {
  const PassWarp& pass;
  float max_u, max_v;
};

template <typename Distort>
EDVO_INLINE void place_points(const PlacerWarp& warp, const Distort& distort,
                              const PointArrays& points, ViewPlaces& __restrict places) {
  const std::array<float, 9>& R = warp.pass.R;
  const std::array<float, 3>& t = warp.pass.t;
  for (std::size_t i = 0; i < points.count; ++i) {
    const float x = points.x[i];
    const float y = points.y[i];
    const float z = points.z[i];
    const float z_cur = R[6] * x + R[7] * y + R[8] * z + t[2];
    const float inverse_z = 1 / (z_cur > 0 ? z_cur : 1);
    const ImagedDirection<float> imaged = image_direction(
        warp.pass.projection, distort, (R[0] * x + R[1] * y + R[2] * z + t[0]) * inverse_z,
        (R[3] * x + R[4] * y + R[5] * z + t[1]) * inverse_z);
    const bool in_view = (z_cur > 0) & (imaged.u >= -0.5F) & (imaged.v >= -0.5F) &
                         (imaged.u < warp.max_u) & (imaged.v < warp.max_v);
    places.u[i] = in_view ? imaged.u : ViewPlaces::kNowhere;
    places.v[i] = in_view ? imaged.v : ViewPlaces::kNowhere;
    places.z[i] = z_cur;
  }
}

EDVO_INLINE void place_points(const PlacerWarp& warp, const PointArrays& points,
                              ViewPlaces& places) {
  dispatch_lens(warp.pass.projection.lens, [&](const auto& distort) EDVO_INLINE_LAMBDA {
    place_points(warp, distort, points, places);
  });
}

void place_baseline(const PlacerWarp& warp, const PointArrays& points, ViewPlaces& places) {
  place_points(warp, points, places);
}

EDVO_TARGET_AVX2 void place_avx2(const PlacerWarp& warp, const PointArrays& points,
                                 ViewPlaces& places) {
  place_points(warp, points, places);
}

}  // namespace

ViewPlacer::ViewPlacer(const PinholeCamera& camera, const SE3& T_cur_ref)
    : warp_(camera, T_cur_ref),
      max_u_(static_cast<float>(camera.width) - 0.5F),
      max_v_(static_cast<float>(camera.height) - 0.5F) {}

void ViewPlacer::place(const PointArrays& points, ViewPlaces& places) const {
  const bool is_baseline = available_instruction_set() == InstructionSet::baseline;
  (is_baseline ? place_baseline : place_avx2)({warp_, max_u_, max_v_}, points, places);
}

}  // namespace vo
