#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "vo/core/instruction_set.h"
#include "vo/geometry/projection.h"
#include "vo/mapping/stereo_pair.h"

/// A camera and an image for many places at once: the loops of `image_direction` and
/// `sample_bilinear` over lanes, with identical bits.
namespace vo::detail {

template <std::size_t kLanes>
using Lanes = std::array<float, kLanes>;

/// The pixels of rays (x, y), px, and the derivatives by (x, y).
template <std::size_t kLanes>
struct ImagedLanes {
  Lanes<kLanes> u, v, du_dx, du_dy, dv_dx, dv_dy;
};

template <std::size_t kLanes, typename Distort>
EDVO_INLINE void distort_lanes(const Projection<float>& camera, const Distort& distort,
                               const Lanes<kLanes>& x, const Lanes<kLanes>& y,
                               ImagedLanes<kLanes>& imaged) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const ImagedDirection<float> pixel = image_direction(camera, distort, x[i], y[i]);
    imaged.u[i] = pixel.u;
    imaged.v[i] = pixel.v;
    imaged.du_dx[i] = pixel.du_dx;
    imaged.du_dy[i] = pixel.du_dy;
    imaged.dv_dx[i] = pixel.dv_dx;
    imaged.dv_dy[i] = pixel.dv_dy;
  }
}

template <std::size_t kLanes>
EDVO_INLINE void image_lanes(const Projection<float>& camera, const Lanes<kLanes>& x,
                             const Lanes<kLanes>& y, ImagedLanes<kLanes>& imaged) {
  dispatch_lens(camera.lens, [&](const auto& distort) EDVO_INLINE_LAMBDA {
    distort_lanes(camera, distort, x, y, imaged);
  });
}

/// An image and the bounds within which it can be sampled.
struct LaneImage {
  const float* pixels;
  int stride;
  SeenBounds bounds;

  explicit LaneImage(const GrayImage& image)
      : pixels(reinterpret_cast<const float*>(image.data)),
        stride(static_cast<int>(image.step1())),
        bounds(image.cols, image.rows) {}
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
    const bool inside = image.bounds.holds(u[i], v[i]);
    safe_u[i] = inside ? u[i] : 1;
    safe_v[i] = inside ? v[i] : 1;
  }
  Lanes<kLanes> values;
  sample_inside(image, safe_u, safe_v, values);
  for (std::size_t i = 0; i < kLanes; ++i) {
    sampled[i] = image.bounds.holds(u[i], v[i]) ? values[i] : outside;
  }
}

}  // namespace vo::detail
