#include "vo/segmentation/motion_support.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "vo/residuals/robust.h"

namespace vo {
namespace {

/// Returns the logarithm of a t-distribution's density but for a constant.
double student_log_density(double residual, double sigma) {
  const double square = residual * residual / (kStudentFreedom * sigma * sigma);
  return -std::log(sigma) - (kStudentFreedom + 1) / 2 * std::log1p(square);
}

/// Returns the logarithm of how much more likely a distance is where the surface is static. Two
/// measurements take part in it.
double distance_evidence(const SurfaceDistance& seen, const DepthNoise& noise) {
  constexpr double kLeastNoise = 0.002;  // share of the depth
  constexpr double kContrast = 0.04;     // share of the depth
  const double depth = seen.depth;
  const double sigma = std::numbers::sqrt2 * std::max(noise.sigma(depth), kLeastNoise * depth);
  return student_log_density(seen.distance, sigma) -
         student_log_density(seen.distance, std::max(kContrast * depth, 2 * sigma));
}

}  // namespace

double intensity_support(const TileEvidence& evidence, const ViewTiles::Values& depths) {
  double sum = 0;
  for (std::size_t tile = 0; tile < evidence.size(); ++tile) {
    const double depth = depths[tile];
    sum += depth * depth * std::clamp(evidence[tile], 0.0F, kMostEvidenceOfFrame);
  }
  return sum;
}

double surface_support(const DepthView& view, const DepthNoise& noise) {
  std::vector<SurfaceDistance> distances;
  surface_distances(view, distances);
  double sum = 0;
  for (const SurfaceDistance& seen : distances) {
    const double depth = seen.depth;
    sum += depth * depth * std::max(0.0, distance_evidence(seen, noise));
  }
  const auto pixels = static_cast<double>(view.image.depth.total());
  return sum * kSurfaceSpacing * kSurfaceSpacing * ViewTiles::kCount / pixels;
}

bool is_clearly_better(const MotionSupport& support, const MotionSupport& other) {
  constexpr double kByIntensities = 1.03;
  constexpr double kByBoth = 1.1;
  return support.by_intensities > kByIntensities * other.by_intensities ||
         support.total() > kByBoth * other.total();
}

}  // namespace vo
