#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "vo/image/pyramid.h"

namespace vo {

/// Whose edges choose the pixels of the reference that are aligned.
enum class EdgeSource {
  current,    ///< the paper: edges of the new image, at the same pixels of the reference
  reference,  ///< the reference's own edges
  both,       ///< the union
};

constexpr auto enum_names(EdgeSource) {
  return std::array{std::pair{EdgeSource::current, "current"},
                    std::pair{EdgeSource::reference, "reference"},
                    std::pair{EdgeSource::both, "both"}};
}

struct EdgePointOptions {
  EdgeSource source = EdgeSource::reference;
  double min_depth = 0.1;  ///< m
  double max_depth = 10;   ///< m

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, EdgePointOptions& options) {
  visit("source", options.source, "whose edges choose the reference's pixels");
  visit("min_depth", options.min_depth, "nearer pixels are not used, m");
  visit("max_depth", options.max_depth, "farther pixels are not used, m");
}

/// The chosen pixels of one pyramid level, one element per point in each array, in scan order.
struct EdgePointLevel {
  std::vector<float> x_ref;      ///< m, in the reference camera's frame
  std::vector<float> y_ref;      ///< m
  std::vector<float> z_ref;      ///< m
  std::vector<float> intensity;  ///< 0..1, of the reference
  std::vector<cv::Point> pixel;  ///< px, where in the reference

  std::size_t size() const { return x_ref.size(); }
};

/// What a reference frame is to the tracker. A depth sensor and a monocular depth map both make
/// one, so the tracker cannot tell which it was. levels[0] is the finest.
struct EdgePoints {
  std::vector<EdgePointLevel> levels;
};

/// How many of a level's own edge pixels have depth in the options' range.
std::size_t edge_pixels_with_depth(const PyramidLevel& level, const EdgePointOptions& options);

/// The pixels of `reference` that lie on an edge of the chosen source and have depth. Both pyramids
/// have edges, the same cameras and the same number of levels.
EdgePoints edge_points(const FramePyramid& reference, const FramePyramid& current,
                       const EdgePointOptions& options);

}  // namespace vo
