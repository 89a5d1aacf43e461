#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "vo/core/instruction_set.h"
#include "vo/geometry/lens_dispatch.h"
#include "vo/mapping/stereo_pair.h"

/// A camera and an image for many places at once: the loops of `image_ray` and `sample_bilinear`
/// over lanes, with identical bits.
namespace vo::detail {

template <std::size_t kLanes>
using Lanes = std::array<float, kLanes>;

/// A camera in single precision.
struct LaneCamera {
  float fx, fy, cx, cy;
  Distortion lens;

  explicit LaneCamera(const PinholeCamera& camera)
      : fx(static_cast<float>(camera.fx)),
        fy(static_cast<float>(camera.fy)),
        cx(static_cast<float>(camera.cx)),
        cy(static_cast<float>(camera.cy)),
        lens(camera.distortion) {}
};

/// The pixels of rays (x, y), px, and the derivatives by (x, y).
template <std::size_t kLanes>
struct ImagedLanes {
  Lanes<kLanes> u, v, du_dx, du_dy, dv_dx, dv_dy;
};

template <std::size_t kLanes, typename Distort>
EDVO_INLINE void distort_lanes(const LaneCamera& camera, const Distort& distort,
                               const Lanes<kLanes>& x, const Lanes<kLanes>& y,
                               ImagedLanes<kLanes>& imaged) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const DistortedPoint<float> point = distort(camera.lens, x[i], y[i]);
    imaged.u[i] = camera.fx * point.x + camera.cx;
    imaged.v[i] = camera.fy * point.y + camera.cy;
    imaged.du_dx[i] = camera.fx * point.dx_dx;
    imaged.du_dy[i] = camera.fx * point.dx_dy;
    imaged.dv_dx[i] = camera.fy * point.dx_dy;
    imaged.dv_dy[i] = camera.fy * point.dy_dy;
  }
}

template <std::size_t kLanes>
EDVO_INLINE void image_lanes(const LaneCamera& camera, const Lanes<kLanes>& x,
                             const Lanes<kLanes>& y, ImagedLanes<kLanes>& imaged) {
  dispatch_lens(camera.lens,
                [&](const auto& distort) { distort_lanes(camera, distort, x, y, imaged); });
}

/// An image and the bounds within which it can be sampled.
struct LaneImage {
  const float* pixels;
  int stride;
  float max_u, max_v;  ///< px; positions below can be sampled

  explicit LaneImage(const GrayImage& image)
      : pixels(reinterpret_cast<const float*>(image.data)),
        stride(static_cast<int>(image.step1())),
        max_u(static_cast<float>(image.cols - 2)),
        max_v(static_cast<float>(image.rows - 2)) {}

  /// Returns whether a position can be sampled, by the bounds of `can_be_sampled`.
  EDVO_INLINE bool holds(float u, float v) const {
    return (u >= 1) & (v >= 1) & (u < max_u) & (v < max_v);
  }
};

/// Samples bilinearly; all positions must be inside.
template <std::size_t kLanes>
EDVO_INLINE void sample_inside(const LaneImage& image, const Lanes<kLanes>& u,
                               const Lanes<kLanes>& v, Lanes<kLanes>& values) {
  std::array<int, kLanes> corner;
  for (std::size_t i = 0; i < kLanes; ++i) {
    corner[i] = static_cast<int>(v[i]) * image.stride + static_cast<int>(u[i]);
  }
  Lanes<2 * kLanes> upper;  // two neighbours in a row
  Lanes<2 * kLanes> lower;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float* pixels = image.pixels + corner[i];
    std::memcpy(upper.data() + 2 * i, pixels, 2 * sizeof(float));
    std::memcpy(lower.data() + 2 * i, pixels + image.stride, 2 * sizeof(float));
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float du = u[i] - static_cast<float>(static_cast<int>(u[i]));
    const float dv = v[i] - static_cast<float>(static_cast<int>(v[i]));
    const float above = upper[2 * i] + du * (upper[2 * i + 1] - upper[2 * i]);
    const float below = lower[2 * i] + du * (lower[2 * i + 1] - lower[2 * i]);
    values[i] = above + dv * (below - above);
  }
}

/// Samples bilinearly; positions outside get the value `outside`.
template <std::size_t kLanes>
EDVO_INLINE void sample_lanes(const LaneImage& image, const Lanes<kLanes>& u,
                              const Lanes<kLanes>& v, float outside, Lanes<kLanes>& sampled) {
  Lanes<kLanes> safe_u;
  Lanes<kLanes> safe_v;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const bool inside = image.holds(u[i], v[i]);
    safe_u[i] = inside ? u[i] : 1;
    safe_v[i] = inside ? v[i] : 1;
  }
  Lanes<kLanes> values;
  sample_inside(image, safe_u, safe_v, values);
  for (std::size_t i = 0; i < kLanes; ++i) {
    sampled[i] = image.holds(u[i], v[i]) ? values[i] : outside;
  }
}

}  // namespace vo::detail
