#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vo/core/image.h"
#include "vo/edges/edges.h"
#include "vo/geometry/camera.h"
#include "vo/image/vignette.h"

namespace vo {

/// The rule that gives the principal point of a halved image.
enum class HalvedPrincipalPoint {
  centred,  ///< (c + 0.5) / 2 - 0.5: pixel centres at integers
  plain,    ///< c / 2, as the paper's authors do
};

constexpr auto enum_names(HalvedPrincipalPoint) {
  return std::array{std::pair{HalvedPrincipalPoint::centred, "centred"},
                    std::pair{HalvedPrincipalPoint::plain, "plain"}};
}

/// The method of halving a depth image.
enum class HalvedDepth {
  surfaces,  ///< `halve_depth`: never across a hole or a step
  cubic,     ///< cubic interpolation, holes as zeros, as the paper's authors do
};

constexpr auto enum_names(HalvedDepth) {
  return std::array{std::pair{HalvedDepth::surfaces, "surfaces"},
                    std::pair{HalvedDepth::cubic, "cubic"}};
}

struct PyramidOptions {
  int levels = 3;  ///< number of levels, each half the size of the next finer; 3 as in the paper
  HalvedPrincipalPoint principal_point = HalvedPrincipalPoint::centred;
  HalvedDepth depth = HalvedDepth::surfaces;

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, PyramidOptions& options) {
  visit("levels", options.levels, "resolutions, each half the size of the one before");
  visit("principal_point", options.principal_point, "what becomes of it at half the size");
  visit("depth", options.depth, "how depth is halved");
}

/// The camera of one level and the ray of each pixel, which do not change from frame to frame.
struct CameraLevel {
  PinholeCamera camera;
  RayImage rays;
  ByteImage unseen;  ///< not 0 where the lens shows nothing, so that the ray is no number; empty
                     ///< where there is no such pixel
};

/// Returns the camera at each level with the ray of every pixel, lens distortion removed. There are
/// fewer levels than asked for if the image would become smaller than 20 px.
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
  Vignette vignette;  ///< vignette that has been removed from the intensities
  std::uint64_t image_fingerprint =
      0;  ///< fingerprint() of the given image, or 0 where none was taken
  std::uint64_t depth_fingerprint = 0;  ///< fingerprint() of the depth, or 0
};

/// Builds the pyramids of a camera's frames, one after the other in the same memory.
class PyramidBuilder {
 public:
  PyramidBuilder(const PinholeCamera& camera, const PyramidOptions& options);

  /// Builds `pyramid` without edges: intensity by 2x2 means, the vignette removed; depth halved as
  /// the options say, none where the lens shows nothing. Its images' memory is reused if nobody
  /// else holds it.
  void build(const RgbdFrame& frame, const Vignette& vignette, FramePyramid& pyramid);

 private:
  void halve_depth_into(const DepthImage& depth, DepthImage& half) const;

  PyramidOptions options_;
  std::vector<CameraLevel> levels_;
  ByteImage luma_;  ///< the frame's luma
};

/// Builds the pyramid of a single frame.
FramePyramid build_pyramid(const RgbdFrame& frame, const PinholeCamera& camera,
                           const PyramidOptions& options);

/// Detects the edges of each level's own intensity, with thresholds chosen for that level.
void add_edges(FramePyramid& pyramid, EdgeFinder& finder);

/// Detects the edges of a single frame's pyramid with an EdgeFinder of these options.
void add_edges(FramePyramid& pyramid, const EdgeOptions& options);

/// Returns the bytes of the images that are this frame's own; the rays belong to the camera.
std::size_t memory_bytes(const FramePyramid& pyramid);

/// Halves an image: each pixel is the mean of four, an odd last row or column is left out. The
/// memory of `half` is reused if nobody else holds it.
void halve(const GrayImage& image, GrayImage& half);

/// Halves a depth image without inventing depths: the mean of the four inverse depths where all are
/// measured and within 5 %, else the nearest (foreground) measured depth, else none.
void halve_depth(const DepthImage& depth, DepthImage& half);

/// Returns half the differences of the neighbours in u and in v, intensity per px; 0 on the border.
cv::Vec2f central_gradient(const GrayImage& image, cv::Point pixel);

/// Returns whether an image looks different without another vignette than the one that has been
/// removed from it.
bool is_noticeable(const Vignette& removed, const Vignette& vignette);

/// Returns the pyramid as it would be if this vignette had been removed from its image.
FramePyramid without_vignette(FramePyramid pyramid, const Vignette& vignette);

}  // namespace vo
