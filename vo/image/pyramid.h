#pragma once

#include <vector>

#include "vo/core/camera.h"
#include "vo/core/image.h"
#include "vo/image/edges.h"

namespace vo {

struct PyramidOptions {
  int levels = 3;  ///< the paper's; each level has half the size of the one before

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, PyramidOptions& options) {
  visit("levels", options.levels, "resolutions, each half the size of the one before");
}

struct PyramidLevel {
  PinholeCamera camera;
  GrayImage intensity;
  GradientImage gradient;
  EdgeMask edges;    ///< empty until `add_edges`
  DepthImage depth;  ///< empty for a monocular frame
};

/// Everything the tracker derives from one image. levels[0] is the finest.
struct FramePyramid {
  double timestamp = 0;  ///< s
  std::vector<PyramidLevel> levels;
};

/// Intensity by 2x2 means, central-difference gradients of each level, depth by `halve_depth`,
/// intrinsics shifted by half a pixel. Fewer levels where the image would become smaller than 20
/// px.
FramePyramid build_pyramid(const RgbdFrame& frame, const PinholeCamera& camera,
                           const PyramidOptions& options);

/// Edges of each level's own intensity, with thresholds of its own.
void add_edges(FramePyramid& pyramid, const EdgeOptions& options);

/// Half the size, each pixel the mean of four. An odd last row or column is left out.
GrayImage halve(const GrayImage& image);

/// Half the size without a depth that nobody measured: the mean of the four inverse depths where
/// all are there and within 5 %, else the nearest (foreground) of those that are there, else none.
DepthImage halve_depth(const DepthImage& depth);

/// (I(u+1) - I(u-1)) / 2 and likewise in v; 0 on the border.
GradientImage central_gradient(const GrayImage& image);

}  // namespace vo
