#pragma once

#include "vo/core/instruction_set.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/lens.h"

/// The projection of a camera, defined once for single points and for the loops over lanes, in
/// double or in single precision.
namespace vo {

/// Points nearer than this are taken to be behind the camera, m along the optical axis.
inline constexpr float kMinVisibleDepth = 0.05F;

/// A camera's intrinsics and lens in the precision of a loop.
template <typename Scalar>
struct Projection {
  Scalar fx, fy, cx, cy;  ///< px
  Distortion lens;

  explicit Projection(const PinholeCamera& camera)
      : fx(static_cast<Scalar>(camera.fx)),
        fy(static_cast<Scalar>(camera.fy)),
        cx(static_cast<Scalar>(camera.cx)),
        cy(static_cast<Scalar>(camera.cy)),
        lens(camera.distortion) {}
};

/// The pixel of a direction (x, y, 1) = (X / Z, Y / Z, 1), and its derivatives by (x, y), px.
template <typename Scalar>
struct ImagedDirection {
  Scalar u, v;
  Scalar du_dx, du_dy, dv_dx, dv_dy;
};

/// Images a direction by the distortion function of the lens's model, which `dispatch_lens`
/// chooses.
template <typename Scalar, typename Distort>
EDVO_INLINE ImagedDirection<Scalar> image_direction(const Projection<Scalar>& projection,
                                                    const Distort& distort, Scalar x, Scalar y) {
  const DistortedPoint<Scalar> imaged = distort(projection.lens, x, y);
  return {projection.fx * imaged.x + projection.cx,
          projection.fy * imaged.y + projection.cy,
          projection.fx * imaged.dx_dx,
          projection.fx * imaged.dx_dy,
          projection.fy * imaged.dx_dy,
          projection.fy * imaged.dy_dy};
}

/// Calls `visit` with the distortion function (lens, x, y) of the lens's model, so that a loop in
/// it is compiled once per model and has no branch.
template <typename Visit>
EDVO_INLINE void dispatch_lens(const Distortion& lens, const Visit& visit) {
  if (lens.is_zero()) {
    visit([]<typename Scalar>(const Distortion&, Scalar x, Scalar y) EDVO_INLINE_LAMBDA {
      return DistortedPoint<Scalar>{x, y, 1, 0, 1};
    });
  } else if (lens.model == DistortionModel::kannala_brandt) {
    visit([]<typename Scalar>(const Distortion& fisheye, Scalar x, Scalar y)
              EDVO_INLINE_LAMBDA { return distort_kannala_brandt(fisheye, x, y); });
  } else if (lens.is_rational()) {
    visit([]<typename Scalar>(const Distortion& rational, Scalar x, Scalar y)
              EDVO_INLINE_LAMBDA { return distort_rational(rational, x, y); });
  } else {
    visit([]<typename Scalar>(const Distortion& brown_conrady, Scalar x, Scalar y)
              EDVO_INLINE_LAMBDA { return distort_brown_conrady(brown_conrady, x, y); });
  }
}

/// Images a direction through a lens of any model.
template <typename Scalar>
inline ImagedDirection<Scalar> image_direction(const Projection<Scalar>& projection, Scalar x,
                                               Scalar y) {
  ImagedDirection<Scalar> imaged;
  dispatch_lens(projection.lens,
                [&](const auto& distort) { imaged = image_direction(projection, distort, x, y); });
  return imaged;
}

/// The positions of an image that are seen: those whose neighbourhood of 4x4 pixels lies inside, so
/// that intensity and gradient can be interpolated bilinearly there.
struct SeenBounds {
  float max_u = 0;  ///< px, the first column that is not seen
  float max_v = 0;  ///< px, the first row that is not seen

  SeenBounds(int width, int height)
      : max_u(static_cast<float>(width - 2)), max_v(static_cast<float>(height - 2)) {}

  EDVO_INLINE bool holds(float u, float v) const {
    return (u >= 1) & (v >= 1) & (u < max_u) & (v < max_v);
  }
};

}  // namespace vo
