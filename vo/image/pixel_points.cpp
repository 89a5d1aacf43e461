#include <algorithm>
#include <array>
#include <cstring>

#include "vo/core/instruction_set.h"
#include "vo/geometry/projection.h"
#include "vo/image/edge_points.h"

namespace vo {
namespace {

constexpr std::size_t kPointsPerBlock = 64;  // points

using BlockRow = std::array<float, kPointsPerBlock>;

/// The values read at some points' pixels and the points computed from them.
struct alignas(64) Block {
  BlockRow ray_x, ray_y, z, sigma;             // X/Z, Y/Z; m
  BlockRow intensity, twice_du, twice_dv;      // intensity; differences over two pixels
  BlockRow dx_dx, dx_dy, dy_dy;                // derivatives of the lens distortion
  BlockRow x_ref, y_ref, dI_dx, dI_dy, dI_dz;  // m, 1/m
};

void gather(const PyramidLevel& level, std::span<const PixelDepth> pixels, Block& block) {
  const GrayImage& image = level.intensity;
  const auto stride = static_cast<std::ptrdiff_t>(image.step1());
  const cv::Rect inside(1, 1, image.cols - 2, image.rows - 2);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const cv::Point pixel = pixels[i].pixel;
    const cv::Vec2f& ray = level.rays(pixel);
    const float* here = &image(pixel);
    const bool has_gradient = inside.contains(pixel);
    block.ray_x[i] = ray[0];
    block.ray_y[i] = ray[1];
    block.z[i] = pixels[i].z;
    block.sigma[i] = pixels[i].sigma;
    block.intensity[i] = *here;
    block.twice_du[i] = has_gradient ? here[1] - here[-1] : 0;
    block.twice_dv[i] = has_gradient ? here[stride] - here[-stride] : 0;
  }
}

/// Prefetches what `gather` reads, because points are too far apart for the processor to do so.
void prefetch(const PyramidLevel& level, std::span<const PixelDepth> pixels) {
  const auto stride = static_cast<std::ptrdiff_t>(level.intensity.step1());
  for (const PixelDepth& each : pixels) {
    const float* here = &level.intensity(each.pixel);
    __builtin_prefetch(&level.rays(each.pixel));
    __builtin_prefetch(here - stride);
    __builtin_prefetch(here);
    __builtin_prefetch(here + stride);
  }
}

template <typename Distort>
EDVO_INLINE void distort_block(const Distortion& lens, const Distort& distort, Block& block) {
  for (std::size_t i = 0; i < kPointsPerBlock; ++i) {
    const DistortedPoint<float> imaged = distort(lens, block.ray_x[i], block.ray_y[i]);
    block.dx_dx[i] = imaged.dx_dx;
    block.dx_dy[i] = imaged.dx_dy;
    block.dy_dy[i] = imaged.dy_dy;
  }
}

/// Computes the derivatives of the lens distortion at the pixels' rays.
EDVO_INLINE void apply_lens(const Distortion& lens, Block& block) {
  dispatch_lens(
      lens, [&](const auto& distort) EDVO_INLINE_LAMBDA { distort_block(lens, distort, block); });
}

/// Computes the points' positions and, from the intensity's derivative by the image coordinates
/// (X/Z, Y/Z), its derivative by the position.
EDVO_INLINE void place(const PinholeCamera& camera, Block& block) {
  const auto fx = static_cast<float>(camera.fx);
  const auto fy = static_cast<float>(camera.fy);
  for (std::size_t i = 0; i < kPointsPerBlock; ++i) {
    const float by_u = 0.5F * block.twice_du[i] * fx;
    const float by_v = 0.5F * block.twice_dv[i] * fy;
    const float inverse_z = 1 / block.z[i];
    const float slope_x = (by_u * block.dx_dx[i] + by_v * block.dx_dy[i]) * inverse_z;
    const float slope_y = (by_u * block.dx_dy[i] + by_v * block.dy_dy[i]) * inverse_z;
    block.dI_dx[i] = slope_x;
    block.dI_dy[i] = slope_y;
    block.dI_dz[i] = -(slope_x * block.ray_x[i] + slope_y * block.ray_y[i]);
    block.x_ref[i] = block.ray_x[i] * block.z[i];
    block.y_ref[i] = block.ray_y[i] * block.z[i];
  }
}

EDVO_TARGET_AVX2 void compute_avx2(const PinholeCamera& camera, Block& block) {
  apply_lens(camera.distortion, block);
  place(camera, block);
}

void compute_baseline(const PinholeCamera& camera, Block& block) {
  apply_lens(camera.distortion, block);
  place(camera, block);
}

void store(const BlockRow& row, std::size_t first, std::size_t count, std::vector<float>& values) {
  std::memcpy(values.data() + first, row.data(), count * sizeof(float));
}

void store(const Block& block, std::size_t first, std::span<const PixelDepth> pixels,
           EdgePointLevel& points) {
  store(block.x_ref, first, pixels.size(), points.x_ref);
  store(block.y_ref, first, pixels.size(), points.y_ref);
  store(block.z, first, pixels.size(), points.z_ref);
  store(block.intensity, first, pixels.size(), points.intensity);
  store(block.dI_dx, first, pixels.size(), points.dI_dx);
  store(block.dI_dy, first, pixels.size(), points.dI_dy);
  store(block.dI_dz, first, pixels.size(), points.dI_dz);
  store(block.sigma, first, pixels.size(), points.depth_sigma);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    points.pixel[first + i] = pixels[i].pixel;
  }
}

}  // namespace

void show_points(const PyramidLevel& level, std::span<const PixelDepth> pixels, InstructionSet set,
                 EdgePointLevel& points) {
  points.resize(pixels.size());
  Block block{};
  block.z.fill(1);
  prefetch(level, pixels.first(std::min(kPointsPerBlock, pixels.size())));
  for (std::size_t first = 0; first < pixels.size(); first += kPointsPerBlock) {
    const auto some = pixels.subspan(first, std::min(kPointsPerBlock, pixels.size() - first));
    const auto rest = pixels.subspan(first + some.size());
    prefetch(level, rest.first(std::min(kPointsPerBlock, rest.size())));
    gather(level, some, block);
    if (set == InstructionSet::baseline) {
      compute_baseline(level.camera, block);
    } else {
      compute_avx2(level.camera, block);
    }
    store(block, first, some, points);
  }
}

}  // namespace vo
