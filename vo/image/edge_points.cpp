#include "vo/image/edge_points.h"

#include <algorithm>
#include <cassert>

#include "vo/core/error.h"
#include "vo/core/hash.h"

namespace vo {
namespace {

constexpr std::size_t kFloatsPerPoint = 8;

EdgeMask edge_mask(const PyramidLevel& reference, const PyramidLevel& current, EdgeSource source) {
  if (source == EdgeSource::both) {
    EdgeMask either;
    cv::bitwise_or(reference.edges, current.edges, either);
    return either;
  }
  return source == EdgeSource::reference ? reference.edges : current.edges;
}

bool is_usable(float depth, const EdgePointOptions& options) {
  return depth >= options.min_depth && depth <= options.max_depth;
}

/// Whether two measured depths near the pixel differ by more than the ratio.
bool is_near_step(const DepthImage& depth, cv::Point pixel, int radius, double ratio) {
  float nearest = depth(pixel);
  float farthest = nearest;
  for (int v = std::max(0, pixel.y - radius); v <= std::min(depth.rows - 1, pixel.y + radius);
       ++v) {
    for (int u = std::max(0, pixel.x - radius); u <= std::min(depth.cols - 1, pixel.x + radius);
         ++u) {
      const float neighbour = depth(v, u);
      if (has_depth(neighbour)) {
        nearest = std::min(nearest, neighbour);
        farthest = std::max(farthest, neighbour);
      }
    }
  }
  return farthest > nearest * static_cast<float>(ratio);
}

/// As many pixels with depth as the mask has, anywhere in the image.
EdgeMask random_mask(const DepthImage& depth, const EdgeMask& mask,
                     const EdgePointOptions& options) {
  std::vector<std::pair<std::uint64_t, int>> ranked;
  std::size_t wanted = 0;
  for (int i = 0; i < depth.rows * depth.cols; ++i) {
    const cv::Point pixel(i % depth.cols, i / depth.cols);
    if (is_usable(depth(pixel), options)) {
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

/// Derivative of the intensity by the image coordinates (X / Z, Y / Z) at a pixel.
cv::Vec2f image_gradient(const PyramidLevel& level, cv::Point pixel, cv::Vec2f ray) {
  const PinholeCamera& camera = level.camera;
  const cv::Vec2f gradient = central_gradient(level.intensity, pixel);
  const float by_u = gradient[0] * static_cast<float>(camera.fx);
  const float by_v = gradient[1] * static_cast<float>(camera.fy);
  if (camera.distortion.is_zero()) {
    return {by_u, by_v};
  }
  const DistortedPoint<float> imaged = distort(camera.distortion, ray[0], ray[1]);
  return {by_u * imaged.dx_dx + by_v * imaged.dx_dy, by_u * imaged.dx_dy + by_v * imaged.dy_dy};
}

}  // namespace

void add_edge_point(const PyramidLevel& level, cv::Point pixel, float z, float depth_sigma,
                    EdgePointLevel& points) {
  const cv::Vec2f ray = level.rays(pixel);
  const cv::Vec2f slope = image_gradient(level, pixel, ray) / z;
  points.x_ref.push_back(ray[0] * z);
  points.y_ref.push_back(ray[1] * z);
  points.z_ref.push_back(z);
  points.intensity.push_back(level.intensity(pixel));
  points.dI_dx.push_back(slope[0]);
  points.dI_dy.push_back(slope[1]);
  points.dI_dz.push_back(-slope.dot(ray));
  points.depth_sigma.push_back(depth_sigma);
  points.pixel.push_back(pixel);
}

Thinning::Thinning(const EdgePointOptions& options, std::size_t count, int width)
    : seed_(options.seed), width_(width) {
  const auto limit = options.max_points > 0 ? static_cast<double>(options.max_points) : 1e18;
  share_ = std::min(options.fraction, limit / std::max(static_cast<double>(count), 1.0));
}

bool Thinning::keeps(cv::Point pixel) const {
  const int index = pixel.y * width_ + pixel.x;
  return share_ >= 1 ||
         mixed_uniform(mixed(seed_ + 1) + static_cast<std::uint64_t>(index)) < share_;
}

namespace {

void thin_out(const EdgePointOptions& options, int width, EdgePointLevel& points) {
  const Thinning thinning(options, points.size(), width);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (thinning.keeps(points.pixel[i])) {
      kept.push_back(i);
    }
  }
  points.keep(kept);
}

EdgePointLevel collect_points(const PyramidLevel& reference, const EdgeMask& mask,
                              const EdgePointOptions& options, int discontinuity_radius) {
  EdgePointLevel points;
  for (int v = 0; v < mask.rows; ++v) {
    const uchar* row = mask[v];
    for (int u = 0; u < mask.cols; ++u) {
      if (row[u] == 0 || !is_usable(reference.depth(v, u), options) ||
          (discontinuity_radius > 0 && is_near_step(reference.depth, {u, v}, discontinuity_radius,
                                                    options.discontinuity_ratio))) {
        continue;
      }
      const float z = reference.depth(v, u);
      add_edge_point(reference, {u, v}, z, structured_light_sigma(z), points);
    }
  }
  thin_out(options, mask.cols, points);
  return points;
}

}  // namespace

void EdgePointOptions::validate() const {
  require(min_depth > 0 && max_depth > min_depth,
          "points: expected 0 < min_depth < max_depth, got ", min_depth, " and ", max_depth);
  require(fraction > 0 && fraction <= 1, "points.fraction: expected above 0 and at most 1, got ",
          fraction);
  require(max_points >= 0, "points.max_points: expected at least 0, got ", max_points);
  require(discontinuity_radius >= 0 && discontinuity_radius <= 10,
          "points.discontinuity_radius: expected 0 to 10, got ", discontinuity_radius);
  require(discontinuity_ratio > 1, "points.discontinuity_ratio: expected above 1, got ",
          discontinuity_ratio);
}

void EdgePointLevel::keep(const std::vector<std::size_t>& indices) {
  for (std::vector<float>* values : std::array<std::vector<float>*, kFloatsPerPoint>{
           &x_ref, &y_ref, &z_ref, &intensity, &dI_dx, &dI_dy, &dI_dz, &depth_sigma}) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      (*values)[i] = (*values)[indices[i]];
    }
    values->resize(indices.size());
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    pixel[i] = pixel[indices[i]];
  }
  pixel.resize(indices.size());
}

std::size_t memory_bytes(const EdgePoints& points) {
  constexpr std::size_t kBytesPerPoint = kFloatsPerPoint * sizeof(float) + sizeof(cv::Point);
  std::size_t bytes = 0;
  for (const EdgePointLevel& level : points.levels) {
    bytes += level.size() * kBytesPerPoint;
  }
  return bytes;
}

std::size_t edge_pixels_with_depth(const PyramidLevel& level, const EdgePointOptions& options) {
  std::size_t count = 0;
  for (int v = 0; v < level.edges.rows; ++v) {
    for (int u = 0; u < level.edges.cols; ++u) {
      count += level.edges(v, u) != 0 && is_usable(level.depth(v, u), options) ? 1 : 0;
    }
  }
  return count;
}

EdgePoints edge_points(const FramePyramid& reference, const FramePyramid& current,
                       const EdgePointOptions& options) {
  assert(reference.levels.size() == current.levels.size());
  EdgePoints points;
  for (std::size_t l = 0; l < reference.levels.size(); ++l) {
    const EdgeMask mask = edge_mask(reference.levels[l], current.levels[l], options.source);
    points.levels.push_back(collect_points(reference.levels[l],
                                           selected(reference.levels[l], mask, options), options,
                                           options.discontinuity_radius >> l));
  }
  return points;
}

}  // namespace vo
