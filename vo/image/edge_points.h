#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "vo/core/hash.h"
#include "vo/core/instruction_set.h"
#include "vo/geometry/depth_noise.h"
#include "vo/image/pyramid.h"

namespace vo {

/// The image whose edges choose the pixels of the reference that are aligned.
enum class EdgeSource {
  current,    ///< the edges of the new image, at the same pixels of the reference, as in the paper
  reference,  ///< the reference's own edges
  both,       ///< the union of both images' edges
};

constexpr auto enum_names(EdgeSource) {
  return std::array{std::pair{EdgeSource::current, "current"},
                    std::pair{EdgeSource::reference, "reference"},
                    std::pair{EdgeSource::both, "both"}};
}

/// The choice of the pixels that are aligned. Other choices than edges are there for comparison
/// only.
enum class PointSelection {
  edges,   ///< edge pixels
  random,  ///< as many pixels as there are edge pixels, at random places
  all,     ///< every pixel: dense alignment
};

constexpr auto enum_names(PointSelection) {
  return std::array{std::pair{PointSelection::edges, "edges"},
                    std::pair{PointSelection::random, "random"},
                    std::pair{PointSelection::all, "all"}};
}

struct EdgePointOptions {
  EdgeSource source = EdgeSource::reference;
  PointSelection selection = PointSelection::edges;
  double fraction = 1;       ///< share of the selected pixels that is kept, at random
  std::uint64_t seed = 0;    ///< seed of the pseudo-random choices
  int max_points = 0;        ///< most points on the finest level, chosen at random; 0 is no limit
  double coarser_share = 1;  ///< factor of max_points from each level to the next coarser one
  double min_depth = 0.1;    ///< m; nearer pixels are not used
  double max_depth = 10;     ///< m; farther pixels are not used
  int discontinuity_radius =
      0;  ///< px; points this near to a depth step are left out; 0 keeps them
  double discontinuity_ratio = 1.05;  ///< ratio of nearby depths that makes a step
  DepthNoise depth_noise;  ///< of the measured depths; where it is not known, structured light's

  EdgePointOptions at_level(std::size_t level) const;  ///< the options for that pyramid level
  void validate() const;                               ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, EdgePointOptions& options) {
  visit("source", options.source, "whose edges choose the reference's pixels");
  visit("selection", options.selection, "which pixels are aligned");
  visit("fraction", options.fraction, "share of the selected pixels that is kept, at random");
  visit("seed", options.seed, "of what is chosen at random");
  visit("max_points", options.max_points, "on the finest level, spread evenly; 0 is no limit");
  visit("coarser_share", options.coarser_share, "of max_points, with each coarser level");
  visit("min_depth", options.min_depth, "nearer pixels are not used, m");
  visit("max_depth", options.max_depth, "farther pixels are not used, m");
  visit("discontinuity_radius", options.discontinuity_radius,
        "pixels this near to a depth step are not used, px of the finest level");
  visit("discontinuity_ratio", options.discontinuity_ratio, "of depths that are a step");
  visit("depth_noise", options.depth_noise,
        "of depth; 0 is the camera's or, where that is unknown, structured light's");
}

/// The chosen pixels of one pyramid level, one element per point in each array, in scan order.
struct EdgePointLevel {
  std::vector<float> x_ref;        ///< m, in the reference camera's frame
  std::vector<float> y_ref;        ///< m, in the reference camera's frame
  std::vector<float> z_ref;        ///< m, in the reference camera's frame
  std::vector<float> intensity;    ///< intensity of the reference image, 0..1
  std::vector<float> dI_dx;        ///< derivative of the intensity by x_ref, 1/m
  std::vector<float> dI_dy;        ///< derivative of the intensity by y_ref, 1/m
  std::vector<float> dI_dz;        ///< derivative of the intensity by z_ref, 1/m
  std::vector<float> depth_sigma;  ///< standard deviation of z_ref, m
  std::vector<cv::Point> pixel;    ///< px, position in the reference image

  std::size_t size() const { return x_ref.size(); }
  void resize(std::size_t count);
  void reserve(std::size_t count);  ///< makes room for later resizes

  /// Keeps the points whose index `is_kept` says true of, called once for each in their order.
  template <typename IsKept>
  void keep_if(IsKept is_kept) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      if (is_kept(i)) {
        for (std::vector<float>* each : values()) {
          (*each)[kept] = (*each)[i];
        }
        pixel[kept] = pixel[i];
        ++kept;
      }
    }
    resize(kept);
  }

  static constexpr std::size_t kFloatsPerPoint = 8;

 private:
  std::array<std::vector<float>*, kFloatsPerPoint> values() {
    return {&x_ref, &y_ref, &z_ref, &intensity, &dI_dx, &dI_dy, &dI_dz, &depth_sigma};
  }
};

/// The points of a reference frame at all pyramid levels; levels[0] is the finest. A depth sensor
/// and a monocular depth map both make such points, so the tracker does not depend on the sensor.
struct EdgePoints {
  std::vector<EdgePointLevel> levels;
};

std::size_t memory_bytes(const EdgePoints& points);

/// A pixel with its depth and that depth's standard deviation.
struct PixelDepth {
  cv::Point pixel;  ///< px
  float z;          ///< m
  float sigma;      ///< m, standard deviation of z
};

/// Fills `points` with the positions, intensities and gradients at pixels of known depth, in the
/// order of `pixels`. Earlier contents of `points` are overwritten.
void show_points(const PyramidLevel& level, std::span<const PixelDepth> pixels, InstructionSet set,
                 EdgePointLevel& points);

/// Decides which of a level's `count` candidates the options' fraction and limit leave: those whose
/// rank in a pseudo-random order of the pixels is low enough.
class Thinning {
 public:
  Thinning(const EdgePointOptions& options, std::size_t count, int width);
  bool keeps(cv::Point pixel) const {
    const std::uint64_t index =
        static_cast<std::uint64_t>(pixel.y) * width_ + static_cast<std::uint64_t>(pixel.x);
    return (mixed(key_ + index) >> kUnusedBits) < ranks_kept_;
  }

 private:
  static constexpr unsigned kUnusedBits = 11;  ///< a double holds the other 53 bits exactly
  static constexpr double kRanks = 0x1p53;

  std::uint64_t key_;
  std::uint64_t width_;  ///< px, width of the level
  std::uint64_t ranks_kept_;
};

/// Returns whether at least `wanted` of a level's own edge pixels have depth in the options' range.
bool has_edge_pixels_with_depth(const PyramidLevel& level, std::size_t wanted,
                                const EdgePointOptions& options);

/// Chooses the points of one frame after the other, reusing its memory.
class EdgePointFinder {
 public:
  explicit EdgePointFinder(EdgePointOptions options) : options_(options) {}

  /// Finds the pixels of `reference` with depth on an edge of the chosen source, overwriting
  /// `points`. Both pyramids must have edges, the same cameras and the same number of levels.
  void find(const FramePyramid& reference, const FramePyramid& current, EdgePoints& points);

 private:
  void find(const PyramidLevel& reference, const EdgeMask& mask, const EdgePointOptions& options,
            EdgePointLevel& points);

  EdgePointOptions options_;
  std::vector<cv::Point> pixels_;
  std::vector<PixelDepth> depths_;
};

/// Chooses the points of a single frame as EdgePointFinder does.
EdgePoints edge_points(const FramePyramid& reference, const FramePyramid& current,
                       const EdgePointOptions& options);

}  // namespace vo
