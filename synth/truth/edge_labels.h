#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// Why there is an edge. Several causes may meet in a pixel.
enum class EdgeCause : std::uint8_t {
  depth,   ///< one surface ends before another, or before nothing
  crease,  ///< a surface bends
  albedo,  ///< its colour changes
  shadow,  ///< a shadow falls on it
};

constexpr auto enum_names(EdgeCause) {
  return std::array{std::pair{EdgeCause::depth, "depth"}, std::pair{EdgeCause::crease, "crease"},
                    std::pair{EdgeCause::albedo, "albedo"}, std::pair{EdgeCause::shadow, "shadow"}};
}

/// The bit of a pixel's labels that stands for a cause.
constexpr std::uint8_t bit(EdgeCause cause) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(cause));
}

/// The bits of each pixel's causes; 0 = no edge.
using EdgeLabels = cv::Mat_<std::uint8_t>;

/// From which step on neighbouring pixels have an edge between them.
struct EdgeLabelOptions {
  double depth_step = 0.01;   ///< share of the depth, beyond what the surface's slope explains
  double crease_deg = 25;     ///< deg between the interpolated normals
  double albedo_step = 0.1;   ///< of the sRGB-encoded base colour (0..1), any channel, in 3 px
  double shadow_step = 0.15;  ///< share of the light that would arrive without shadows

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, EdgeLabelOptions& options) {
  visit("depth_step", options.depth_step, "least step of a depth edge, share of the depth");
  visit("crease_deg", options.crease_deg, "least bend of a crease, deg");
  visit("albedo_step", options.albedo_step, "least step of sRGB-encoded base colour in 3 px, 0..1");
  visit("shadow_step", options.shadow_step, "least step of a shadow, share of the light");
}

/// Exact edges, about a pixel wide: an edge between a pixel and its right or lower neighbour marks
/// the nearer surface if depth steps, else the left or upper pixel. A colour that changes over
/// several pixels has its edge where it changes most; creases and shadows are looked for where
/// depth does not step. `camera` is the one that saw the view.
EdgeLabels edge_labels(const SurfaceView& view, const vo::PinholeCamera& camera,
                       const EdgeLabelOptions& options);

}  // namespace synth
