#include "vo/image/edge_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "vo/core/error.h"
#include "vo/core/hash.h"
#include "vo/core/instruction_set.h"
#include "vo/core/pixel_bits.h"
#include "vo/image/usable_pixels.h"

namespace vo {
namespace {

EdgeMask edge_mask(const PyramidLevel& reference, const PyramidLevel& current, EdgeSource source) {
  if (source == EdgeSource::both) {
    EdgeMask either;
    cv::bitwise_or(reference.edges, current.edges, either);
    return either;
  }
  return source == EdgeSource::reference ? reference.edges : current.edges;
}

UsableDepth usable_depth(const EdgePointOptions& options) {
  return {static_cast<float>(options.min_depth), static_cast<float>(options.max_depth),
          options.discontinuity_radius, static_cast<float>(options.discontinuity_ratio)};
}

/// Returns a mask of as many pixels as `mask` has with depth in range, anywhere such depth is.
EdgeMask random_mask(const DepthImage& depth, const EdgeMask& mask,
                     const EdgePointOptions& options) {
  const UsableDepth usable = usable_depth(options);
  std::vector<std::pair<std::uint64_t, int>> ranked;
  std::size_t wanted = 0;
  for (int i = 0; i < depth.rows * depth.cols; ++i) {
    const cv::Point pixel(i % depth.cols, i / depth.cols);
    if (usable.is_in_range(depth(pixel))) {
      ranked.emplace_back(mixed(mixed(options.seed) + static_cast<std::uint64_t>(i)), i);
      wanted += mask(pixel) != 0 ? 1 : 0;
    }
  }
  const auto end = ranked.begin() + static_cast<std::ptrdiff_t>(wanted);
  std::nth_element(ranked.begin(), end, ranked.end());
  EdgeMask random(mask.size(), uchar{0});
  for (auto it = ranked.begin(); it != end; ++it) {
    random(it->second / depth.cols, it->second % depth.cols) = 255;
  }
  return random;
}

EdgeMask selected(const PyramidLevel& reference, const EdgeMask& edges,
                  const EdgePointOptions& options) {
  if (options.selection == PointSelection::all) {
    return {edges.size(), uchar{255}};
  }
  return options.selection == PointSelection::random ? random_mask(reference.depth, edges, options)
                                                     : edges;
}

}  // namespace

Thinning::Thinning(const EdgePointOptions& options, std::size_t count, int width)
    : key_(mixed(options.seed + 1)), width_(static_cast<std::uint64_t>(width)) {
  const auto limit = options.max_points > 0 ? static_cast<double>(options.max_points) : 1e18;
  const double share =
      std::min(options.fraction, limit / std::max(static_cast<double>(count), 1.0));
  ranks_kept_ = static_cast<std::uint64_t>(std::ceil(share * kRanks));
}

namespace {

/// Moves the pixels that are kept to the front, and returns how many they are. The ranks of 64
/// pixels are computed at once.
EDVO_INLINE std::size_t move_kept(const Thinning& thinning, std::vector<cv::Point>& pixels) {
  constexpr std::size_t kAtOnce = 64;
  std::array<uchar, kAtOnce> is_kept;
  std::size_t kept = 0;
  for (std::size_t first = 0; first < pixels.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, pixels.size() - first);
    const cv::Point* some = pixels.data() + first;
    for (std::size_t i = 0; i < count; ++i) {
      is_kept[i] = thinning.keeps(some[i]) ? 1 : 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
      pixels[kept] = some[i];
      kept += is_kept[i];
    }
  }
  return kept;
}

std::size_t move_kept_baseline(const Thinning& thinning, std::vector<cv::Point>& pixels) {
  return move_kept(thinning, pixels);
}

EDVO_TARGET_AVX512 std::size_t move_kept_avx512(const Thinning& thinning,
                                                std::vector<cv::Point>& pixels) {
  return move_kept(thinning, pixels);
}

void thin_out(const EdgePointOptions& options, int width, std::vector<cv::Point>& pixels) {
  const Thinning thinning(options, pixels.size(), width);
  const auto move =
      available_instruction_set() == InstructionSet::avx512 ? move_kept_avx512 : move_kept_baseline;
  pixels.resize(move(thinning, pixels));
}

}  // namespace

EdgePointOptions EdgePointOptions::at_level(std::size_t level) const {
  EdgePointOptions result = *this;
  result.max_points =
      static_cast<int>(std::ceil(max_points * std::pow(coarser_share, static_cast<double>(level))));
  result.discontinuity_radius >>= level;
  return result;
}

void EdgePointOptions::validate() const {
  require(coarser_share > 0 && coarser_share <= 1,
          "points.coarser_share: expected above 0 and at most 1, got ", coarser_share);
  require(min_depth > 0 && max_depth > min_depth,
          "points: expected 0 < min_depth < max_depth, got ", min_depth, " and ", max_depth);
  require(fraction > 0 && fraction <= 1, "points.fraction: expected above 0 and at most 1, got ",
          fraction);
  require(max_points >= 0, "points.max_points: expected at least 0, got ", max_points);
  require(discontinuity_radius >= 0 && discontinuity_radius <= 10,
          "points.discontinuity_radius: expected 0 to 10, got ", discontinuity_radius);
  depth_noise.validate();
  require(discontinuity_ratio > 1, "points.discontinuity_ratio: expected above 1, got ",
          discontinuity_ratio);
}

void EdgePointLevel::resize(std::size_t count) {
  for (std::vector<float>* each : values()) {
    each->resize(count);
  }
  pixel.resize(count);
}

void EdgePointLevel::reserve(std::size_t count) {
  for (std::vector<float>* each : values()) {
    each->reserve(count);
  }
  pixel.reserve(count);
}

std::size_t memory_bytes(const EdgePoints& points) {
  constexpr std::size_t kBytesPerPoint =
      EdgePointLevel::kFloatsPerPoint * sizeof(float) + sizeof(cv::Point);
  std::size_t bytes = 0;
  for (const EdgePointLevel& level : points.levels) {
    bytes += level.size() * kBytesPerPoint;
  }
  return bytes;
}

bool has_edge_pixels_with_depth(const PyramidLevel& level, std::size_t wanted,
                                const EdgePointOptions& options) {
  const UsableDepth usable = usable_depth(options);
  std::size_t count = 0;
  for (int v = 0; v < level.edges.rows && count < wanted; ++v) {
    for_each_set(level.edges[v], level.edges.cols,
                 [&](int u) { count += usable.is_in_range(level.depth(v, u)) ? 1 : 0; });
  }
  return count >= wanted;
}

void EdgePointFinder::find(const PyramidLevel& reference, const EdgeMask& mask,
                           const EdgePointOptions& options, EdgePointLevel& points) {
  find_usable_pixels(reference.depth, mask, usable_depth(options), pixels_);
  thin_out(options, mask.cols, pixels_);
  depths_.clear();
  const DepthNoise noise = known_depth_noise(options.depth_noise);
  for (const cv::Point pixel : pixels_) {
    const float z = reference.depth(pixel);
    depths_.push_back({pixel, z, static_cast<float>(noise.sigma(z))});
  }
  constexpr double kSpread = 1.125;  // most points that thinning keeps, times those wanted
  points.reserve(static_cast<std::size_t>(kSpread * options.max_points));
  show_points(reference, depths_, available_instruction_set(), points);
}

void EdgePointFinder::find(const FramePyramid& reference, const FramePyramid& current,
                           EdgePoints& points) {
  assert(reference.levels.size() == current.levels.size());
  points.levels.resize(reference.levels.size());
  for (std::size_t l = 0; l < reference.levels.size(); ++l) {
    const PyramidLevel& level = reference.levels[l];
    const EdgeMask mask = edge_mask(level, current.levels[l], options_.source);
    find(level, selected(level, mask, options_), options_.at_level(l), points.levels[l]);
  }
}

EdgePoints edge_points(const FramePyramid& reference, const FramePyramid& current,
                       const EdgePointOptions& options) {
  EdgePoints points;
  EdgePointFinder(options).find(reference, current, points);
  return points;
}

}  // namespace vo
