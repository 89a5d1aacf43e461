#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

#include "synth/depth_sensor/depth_noise.h"
#include "vo/core/image.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// The conditions under which a depth camera measures nothing.
struct DepthHoles {
  double max_incidence_deg = 90;    ///< deg, greatest measured angle of normal and ray; 90 = any
  double sure_incidence_deg = 90;   ///< deg, from which losses grow linearly up to the maximum
  double max_step = 0;              ///< m, greatest depth range of 3x3 pixels; 0 = any
  double edge_loss = 0;             ///< share of pixels lost beside depth edges
  double dark_level = 0;            ///< grey level, 0..255, below which pixels have no depth
  double second_view = 0;           ///< m to the right, of a projector or second camera; 0 = none
  bool second_view_framed = false;  ///< whether the second view is only as wide as the image
  double correlation = 0;           ///< px, blur sigma that correlates random losses
  std::uint64_t seed = 0;
};

/// Flying pixels: pixels at a depth edge that measure a depth between both surfaces.
struct FlyingPixels {
  double share = 0;  ///< share of the pixels beside depth edges
  std::uint64_t seed = 0;
};

template <typename Visitor>
void visit_fields(Visitor& visit, DepthHoles& holes) {
  visit("max_incidence_deg", holes.max_incidence_deg, "greatest angle of normal and ray, deg");
  visit("sure_incidence_deg", holes.sure_incidence_deg, "from here on some are lost, deg");
  visit("max_step", holes.max_step, "greatest difference within 3x3 pixels, m; 0 = any");
  visit("edge_loss", holes.edge_loss, "share of pixels lost beside depth edges");
  visit("dark_level", holes.dark_level, "pixels with less grey (0 to 255) have no depth");
  visit("second_view", holes.second_view,
        "m to the right: a projector or camera whose shadows have no depth; 0 = none");
  visit("second_view_framed", holes.second_view_framed, "whether it sees no more than an image");
  visit("correlation", holes.correlation, "between what neighbours lose by chance, px");
  visit("seed", holes.seed, "of what is lost by chance");
}

template <typename Visitor>
void visit_fields(Visitor& visit, FlyingPixels& flying) {
  visit("share", flying.share, "of pixels beside depth edges that measure something between");
  visit("seed", flying.seed, "of these");
}

/// The least and greatest depth of the 3x3 pixels around a pixel, m; both 0 without any depth.
struct DepthSpan {
  float nearest = 0;
  float farthest = 0;

  /// Returns whether the farthest depth exceeds the nearest by more than a tenth.
  bool is_edge() const { return farthest > 1.1F * nearest; }
};

DepthSpan span_around(const vo::DepthImage& depth, const cv::Point& pixel);

/// Returns 255 where a second camera or projector, a baseline b to the right with parallel axes,
/// sees the surface too: pixel u of depth Z is at u - f b / Z there, and the nearer surface
/// occludes the farther. `framed` limits the second view to the image's width.
cv::Mat_<uchar> seen_from_beside(const vo::DepthImage& depth, double focal_px, double baseline,
                                 bool framed);

/// Returns `measured` without the pixels that the sensor loses in `view`; ignores `dark_level`.
vo::DepthImage with_holes(const vo::DepthImage& measured, const DepthView& view,
                          const vo::CameraModel& camera, const DepthHoles& holes,
                          std::uint64_t frame);

vo::DepthImage with_flying_pixels(const vo::DepthImage& measured, const vo::DepthImage& exact,
                                  const FlyingPixels& flying, std::uint64_t frame);

/// Returns the depth without pixels that are darker than `level`, 0..255, in the registered image.
vo::DepthImage without_dark(const vo::DepthImage& depth, const vo::ColorImage& image, double level);

}  // namespace synth
