#include "vo/segmentation/depth_deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "vo/residuals/warp.h"

namespace vo {
namespace {

constexpr std::size_t kMostPixels = 1200;

/// Returns the least distance between pixels of a square grid that has at most kMostPixels.
int grid_spacing(const DepthImage& image) {
  int spacing = 1;
  const auto pixels = [&](int extent) {
    return static_cast<std::size_t>((extent + spacing - 1) / spacing);
  };
  while (pixels(image.rows) * pixels(image.cols) > kMostPixels) {
    ++spacing;
  }
  return spacing;
}

/// Compares pixels of the reference with the current depth image.
class Comparison {
 public:
  Comparison(const DepthPair& pair, const DepthNoise& noise, const TileMask& moving)
      : pair_(pair),
        noise_(noise),
        moving_(moving),
        tiles_(pair.current.camera),
        warp_(pair.current.camera, pair.T_cur_ref) {}

  /// Returns how much the depths differ beyond noise, or nothing where there is nothing to compare.
  std::optional<float> at(int u, int v) const {
    constexpr float kMost = 0.1F;  // share of the depth
    const float depth = pair_.reference.depth(v, u);
    if (!has_depth(depth)) {
      return {};
    }
    const cv::Vec2f& ray = pair_.reference.rays(v, u);
    const WarpedPoint<float> point =
        warp_point<float>(warp_, {depth * ray[0], depth * ray[1], depth});
    if (!is_in_view(point, pair_.current.camera) || moving_[tiles_.of(point.u, point.v)]) {
      return {};
    }
    const float expected = point.p_cur.z();
    const float measured = pair_.current.depth(cvRound(point.v), cvRound(point.u));
    if (!has_depth(measured) || measured < (1 - kMost) * expected) {
      return {};
    }
    const auto sigma = static_cast<float>(std::numbers::sqrt2 * noise_.sigma(expected));
    return std::min(std::max(0.0F, std::abs(measured - expected) - sigma) / expected, kMost);
  }

 private:
  const DepthPair& pair_;
  const DepthNoise& noise_;
  const TileMask& moving_;
  ViewTiles tiles_;
  Warp<float> warp_;
};

}  // namespace

double depth_deviation(const DepthPair& pair, const DepthNoise& noise, const TileMask& moving) {
  constexpr std::size_t kFewest = 50;
  const Comparison comparison(pair, noise, moving);
  const DepthImage& depth = pair.reference.depth;
  const int spacing = grid_spacing(depth);
  std::array<float, kMostPixels> deviations;
  std::size_t count = 0;
  for (int v = 0; v < depth.rows; v += spacing) {
    for (int u = 0; u < depth.cols; u += spacing) {
      if (const std::optional<float> deviation = comparison.at(u, v)) {
        deviations[count++] = *deviation;
      }
    }
  }
  if (count < kFewest) {
    return 0;
  }
  float* const middle = deviations.data() + count / 2;
  std::nth_element(deviations.data(), middle, deviations.data() + count);
  return static_cast<double>(*middle);
}

}  // namespace vo
