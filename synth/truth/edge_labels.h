#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// The cause of an edge. Several causes may meet in a pixel.
enum class EdgeCause : std::uint8_t {
  depth,   ///< occluding boundary, before another surface or nothing
  crease,  ///< change of surface orientation
  albedo,  ///< change of base colour
  shadow,  ///< boundary of a shadow
};

constexpr auto enum_names(EdgeCause) {
  return std::array{std::pair{EdgeCause::depth, "depth"}, std::pair{EdgeCause::crease, "crease"},
                    std::pair{EdgeCause::albedo, "albedo"}, std::pair{EdgeCause::shadow, "shadow"}};
}

/// Returns the bit of a pixel's labels that stands for a cause.
constexpr std::uint8_t bit(EdgeCause cause) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(cause));
}

/// An image of the bits of each pixel's causes; 0 = no edge.
using EdgeLabels = cv::Mat_<std::uint8_t>;

/// The least differences of neighbouring pixels that make an edge between them.
struct EdgeLabelOptions {
  double depth_step = 0.01;   ///< share of the depth, beyond what the surface's slope explains
  double crease_deg = 25;     ///< deg between the interpolated normals
  double albedo_step = 0.1;   ///< step of sRGB-encoded base colour (0..1), any channel, in 3 px
  double shadow_step = 0.15;  ///< step in the share of light that shadows leave

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, EdgeLabelOptions& options) {
  visit("depth_step", options.depth_step, "least step of a depth edge, share of the depth");
  visit("crease_deg", options.crease_deg, "least bend of a crease, deg");
  visit("albedo_step", options.albedo_step, "least step of sRGB-encoded base colour in 3 px, 0..1");
  visit("shadow_step", options.shadow_step, "least step of a shadow, share of the light");
}

/// Returns exact edges, about a pixel wide: an edge between a pixel and its right or lower
/// neighbour marks the nearer surface if depth steps, else the left or upper pixel. A gradual
/// change of colour has its edge where it is steepest. Other causes are only tested where depth
/// does not step. `camera` is the one that saw the view; in an image that wraps, the last column's
/// right neighbour is the first.
EdgeLabels edge_labels(const SurfaceView& view, const vo::CameraModel& camera,
                       const EdgeLabelOptions& options);

}  // namespace synth
