#include "vo/image/edge_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "vo/core/error.h"
#include "vo/core/hash.h"
#include "vo/image/depth_span.h"

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

bool is_usable(float depth, const EdgePointOptions& options) {
  return depth >= options.min_depth && depth <= options.max_depth;
}

/// Whether two measured depths near the pixel differ by more than the ratio.
bool is_near_step(const DepthImage& depth, cv::Point pixel, int radius, float ratio) {
  const DepthSpan span = depth_span(depth, pixel, radius);
  return span.farthest > span.nearest * ratio;
}

/// Calls `visit(u)` for each set pixel of a mask's row. Few are, so eight are skipped at a time.
template <typename Visit>
void for_each_set(const uchar* row, int cols, Visit visit) {
  constexpr int kStride = 8;
  for (int u = 0; u < cols; ++u) {
    std::uint64_t ahead = 0;
    while (u + kStride <= cols && (std::memcpy(&ahead, row + u, kStride), ahead == 0)) {
      u += kStride;
    }
    if (u < cols && row[u] != 0) {
      visit(u);
    }
  }
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

void set_edge_point(const PyramidLevel& level, cv::Point pixel, const PointDepth& depth,
                    std::size_t index, EdgePointLevel& points) {
  const cv::Vec2f ray = level.rays(pixel);
  const cv::Vec2f slope = image_gradient(level, pixel, ray) / depth.z;
  points.x_ref[index] = ray[0] * depth.z;
  points.y_ref[index] = ray[1] * depth.z;
  points.z_ref[index] = depth.z;
  points.intensity[index] = level.intensity(pixel);
  points.dI_dx[index] = slope[0];
  points.dI_dy[index] = slope[1];
  points.dI_dz[index] = -slope.dot(ray);
  points.depth_sigma[index] = depth.sigma;
  points.pixel[index] = pixel;
}

}  // namespace

void add_edge_point(const PyramidLevel& level, cv::Point pixel, const PointDepth& depth,
                    EdgePointLevel& points) {
  points.resize(points.size() + 1);
  set_edge_point(level, pixel, depth, points.size() - 1, points);
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

/// The mask's pixels that have depth and are not near a step, in scan order.
std::vector<cv::Point> usable_pixels(const DepthImage& depth, const EdgeMask& mask,
                                     const EdgePointOptions& options) {
  const auto ratio = static_cast<float>(options.discontinuity_ratio);
  std::vector<cv::Point> pixels;
  for (int v = 0; v < mask.rows; ++v) {
    for_each_set(mask[v], mask.cols, [&](int u) {
      if (is_usable(depth(v, u), options) &&
          (options.discontinuity_radius == 0 ||
           !is_near_step(depth, {u, v}, options.discontinuity_radius, ratio))) {
        pixels.emplace_back(u, v);
      }
    });
  }
  return pixels;
}

void thin_out(const EdgePointOptions& options, int width, std::vector<cv::Point>& pixels) {
  const Thinning thinning(options, pixels.size(), width);
  const auto is_left_out = [&](cv::Point pixel) { return !thinning.keeps(pixel); };
  pixels.erase(std::remove_if(pixels.begin(), pixels.end(), is_left_out), pixels.end());
}

EdgePointLevel collect_points(const PyramidLevel& reference, const EdgeMask& mask,
                              const EdgePointOptions& options) {
  std::vector<cv::Point> pixels = usable_pixels(reference.depth, mask, options);
  thin_out(options, mask.cols, pixels);
  EdgePointLevel points;
  points.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const float z = reference.depth(pixels[i]);
    set_edge_point(reference, pixels[i], {z, structured_light_sigma(z)}, i, points);
  }
  return points;
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
  require(discontinuity_ratio > 1, "points.discontinuity_ratio: expected above 1, got ",
          discontinuity_ratio);
}

auto EdgePointLevel::values() -> std::array<std::vector<float>*, kFloatsPerPoint> {
  return {&x_ref, &y_ref, &z_ref, &intensity, &dI_dx, &dI_dy, &dI_dz, &depth_sigma};
}

void EdgePointLevel::resize(std::size_t count) {
  for (std::vector<float>* each : values()) {
    each->resize(count);
  }
  pixel.resize(count);
}

void EdgePointLevel::keep(const std::vector<std::size_t>& indices) {
  for (std::vector<float>* each : values()) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      (*each)[i] = (*each)[indices[i]];
    }
    each->resize(indices.size());
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    pixel[i] = pixel[indices[i]];
  }
  pixel.resize(indices.size());
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
  std::size_t count = 0;
  for (int v = 0; v < level.edges.rows && count < wanted; ++v) {
    for_each_set(level.edges[v], level.edges.cols,
                 [&](int u) { count += is_usable(level.depth(v, u), options) ? 1 : 0; });
  }
  return count >= wanted;
}

EdgePoints edge_points(const FramePyramid& reference, const FramePyramid& current,
                       const EdgePointOptions& options) {
  assert(reference.levels.size() == current.levels.size());
  EdgePoints points;
  for (std::size_t l = 0; l < reference.levels.size(); ++l) {
    const EdgeMask mask = edge_mask(reference.levels[l], current.levels[l], options.source);
    points.levels.push_back(collect_points(
        reference.levels[l], selected(reference.levels[l], mask, options), options.at_level(l)));
  }
  return points;
}

}  // namespace vo
