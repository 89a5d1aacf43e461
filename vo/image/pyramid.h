#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "vo/core/image.h"
#include "vo/edges/edges.h"
#include "vo/geometry/camera.h"
#include "vo/image/vignette.h"

namespace vo {

/// What becomes of the principal point when the image is halved.
enum class HalvedPrincipalPoint {
  centred,  ///< (c + 0.5) / 2 - 0.5: pixel centres at integers
  plain,    ///< c / 2, as the paper's authors do
};

constexpr auto enum_names(HalvedPrincipalPoint) {
  return std::array{std::pair{HalvedPrincipalPoint::centred, "centred"},
                    std::pair{HalvedPrincipalPoint::plain, "plain"}};
}

/// How depth is halved.
enum class HalvedDepth {
  surfaces,  ///< `halve_depth`: never across a hole or a step
  cubic,     ///< cubic interpolation, holes as zeros, as the paper's authors do
};

constexpr auto enum_names(HalvedDepth) {
  return std::array{std::pair{HalvedDepth::surfaces, "surfaces"},
                    std::pair{HalvedDepth::cubic, "cubic"}};
}

struct PyramidOptions {
  int levels = 3;  ///< the paper's; each level has half the size of the one before
  HalvedPrincipalPoint principal_point = HalvedPrincipalPoint::centred;
  HalvedDepth depth = HalvedDepth::surfaces;

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, PyramidOptions& options) {
  visit("levels", options.levels, "resolutions, each half the size of the one before");
  visit("principal_point", options.principal_point, "what becomes of it at half the size");
  visit("depth", options.depth, "how depth is halved");
}

/// What does not change from frame to frame at one level.
struct CameraLevel {
  PinholeCamera camera;
  RayImage rays;
};

/// The levels of a camera: intrinsics shifted by half a pixel, the ray of every pixel with the lens
/// taken out. Fewer levels where the image would become smaller than 20 px.
std::vector<CameraLevel> camera_levels(const PinholeCamera& camera, const PyramidOptions& options);

struct PyramidLevel {
  PinholeCamera camera;
  RayImage rays;
  GrayImage intensity;
  EdgeMask edges;    ///< empty until `add_edges`
  DepthImage depth;  ///< empty for a monocular frame
};

/// Everything the tracker derives from one image. levels[0] is the finest.
struct FramePyramid {
  double timestamp = 0;  ///< s
  std::vector<PyramidLevel> levels;
  Vignette vignette;  ///< taken out of the intensities
};

/// Builds the pyramids of a camera's frames, one after the other in the same memory.
class PyramidBuilder {
 public:
  PyramidBuilder(const PinholeCamera& camera, const PyramidOptions& options);

  /// Intensity by 2x2 means, the vignette taken out of it; depth as the options say. No edges. What
  /// `pyramid` was before is forgotten; its images' memory is used where nobody else holds it.
  void build(const RgbdFrame& frame, const Vignette& vignette, FramePyramid& pyramid);

 private:
  void halve_depth_into(const DepthImage& depth, DepthImage& half) const;

  PyramidOptions options_;
  std::vector<CameraLevel> levels_;
  ByteImage luma_;  ///< of the frame
};

/// The pyramid of a single frame.
FramePyramid build_pyramid(const RgbdFrame& frame, const PinholeCamera& camera,
                           const PyramidOptions& options);

/// Edges of each level's own intensity, with thresholds of its own.
void add_edges(FramePyramid& pyramid, EdgeFinder& finder);

/// The same for a single frame.
void add_edges(FramePyramid& pyramid, const EdgeOptions& options);

/// Bytes of the images that are this frame's own; the rays belong to the camera.
std::size_t memory_bytes(const FramePyramid& pyramid);

/// Half the size, each pixel the mean of four. An odd last row or column is left out. The memory of
/// `half` is used if nobody else holds it.
void halve(const GrayImage& image, GrayImage& half);

/// Half the size without a depth that nobody measured: the mean of the four inverse depths where
/// all are there and within 5 %, else the nearest (foreground) of those that are there, else none.
void halve_depth(const DepthImage& depth, DepthImage& half);

/// (I(u+1) - I(u-1)) / 2 and likewise in v, intensity per px; 0 on the border.
cv::Vec2f central_gradient(const GrayImage& image, cv::Point pixel);

}  // namespace vo
