#include "synth/sequence/depth_coverage.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <tbb/parallel_for.h>

#include "synth/scene/vertex_sample.h"
#include "vo/core/error.h"
#include "vo/frames/depth_units.h"

namespace synth {
namespace {

/// The number of times by which a scene in millimetres is farther away than depth reaches, at
/// least. One in metres would have to stand hundreds of metres from its camera.
constexpr double kMillimetreRatio = 30;

/// The number of pixels of a depth image, and of those with depth; 0 if it cannot be read.
struct DepthCount {
  int pixels = 0;
  int with_depth = 0;
};

DepthCount count_depth(const std::filesystem::path& file, const vo::RgbdCameraModel& camera) {
  try {
    const vo::DepthImage depth = vo::read_depth_png(file, camera);
    return {static_cast<int>(depth.total()), cv::countNonZero(depth)};
  } catch (const vo::Error&) {  // a damaged image of an unfinished sequence
    return {};
  }
}

/// Returns the greatest depth, m, that a frame may hold.
double reach_of(const SequenceRecipe& recipe) {
  return std::min(recipe.sensor.max_depth, vo::farthest_in_16_bit(recipe.camera.depth_units_per_m));
}

/// Returns the median distance, m, from the sequence's first camera position to the scene's
/// vertices; 0 for a scene without any.
double median_distance(const Scene& scene, const SequenceRecipe& recipe) {
  const Eigen::Vector3d eye = recipe.truth.front().T_world_camera.translation();
  std::vector<double> distances;
  for (const Eigen::Vector3d& vertex : sample_vertices(scene)) {
    distances.push_back((vertex - eye).norm());
  }
  if (distances.empty()) {
    return 0;
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace

std::optional<double> depth_coverage(const SequenceRecipe& recipe,
                                     const std::vector<std::size_t>& frames,
                                     const std::filesystem::path& folder) {
  std::vector<DepthCount> counts(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    counts[i] = count_depth(folder / depth_file(recipe, frames[i]), recipe.camera);
  });
  double pixels = 0;
  double with_depth = 0;
  for (const DepthCount& count : counts) {
    pixels += count.pixels;
    with_depth += count.with_depth;
  }
  return pixels > 0 ? std::optional(with_depth / pixels) : std::nullopt;
}

std::string warn_of_coverage(const Scene& scene, const SequenceRecipe& recipe, double coverage) {
  if (coverage >= kLeastDepthCoverage) {
    return {};
  }
  std::string text =
      vo::concat("only ", std::round(1e4 * coverage) / 1e2, " % of the pixels have depth");
  const double reach = reach_of(recipe);
  const double distance = median_distance(scene, recipe);
  if (distance > kMillimetreRatio * reach) {
    text += vo::concat("; half of the scene's vertices are more than ", std::round(distance),
                       " m from the camera, whose depth ends at ", reach,
                       " m: if the scene is in millimetres, --scene-scale 0.001 mends it "
                       "(scene.scale in a scenario)");
  }
  return text;
}

}  // namespace synth
