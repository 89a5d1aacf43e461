#include "vo/residuals/depth_term.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vo/residuals/lane_sums.h"
#include "vo/residuals/median_magnitude.h"
#include "vo/residuals/warp.h"

namespace vo {
namespace {

using detail::Block;
using detail::BlockRow;
using detail::kBlock;
using detail::LaneSums;
using detail::PassWarp;

/// The planes that a block of surface points is compared with.
struct alignas(64) Planes {
  BlockRow nx, ny, nz;                          // the points' normals in the current frame
  BlockRow measured_x, measured_y, measured_z;  // m, surface points that the image measures
};

void load_surface(const SurfacePoints& surface, std::size_t first, std::size_t count, Block& block,
                  Planes& planes) {
  block.z_ref.fill(1);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f& position = surface.position[first + i];
    const Eigen::Vector3f& normal = surface.normal[first + i];
    block.x_ref[i] = position.x();
    block.y_ref[i] = position.y();
    block.z_ref[i] = position.z();
    planes.nx[i] = normal.x();
    planes.ny[i] = normal.y();
    planes.nz[i] = normal.z();
  }
}

/// Looks up the measured depth at the nearest pixel, because depth is never interpolated.
EDVO_INLINE void measure(const PyramidLevel& image, std::size_t count, const Block& block,
                         Planes& planes) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto u = static_cast<int>(std::floor(block.u[i] + 0.5F));
    const auto v = static_cast<int>(std::floor(block.v[i] + 0.5F));
    const cv::Vec2f& ray = image.rays(v, u);
    const float depth = image.depth(v, u);
    planes.measured_x[i] = depth * ray[0];
    planes.measured_y[i] = depth * ray[1];
    planes.measured_z[i] = depth;
  }
}

/// Turns the normals to the current frame and computes the distances, stored as the block's
/// intensity. A point counts as unseen where no depth or that of another surface is measured.
EDVO_INLINE void compare(const PassWarp& warp, Block& block, Planes& planes) {
  constexpr float kMaxStep = 0.1F;  // share of the depth
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = planes.nx[i];
    const float y = planes.ny[i];
    const float z = planes.nz[i];
    planes.nx[i] = warp.R[0] * x + warp.R[1] * y + warp.R[2] * z;
    planes.ny[i] = warp.R[3] * x + warp.R[4] * y + warp.R[5] * z;
    planes.nz[i] = warp.R[6] * x + warp.R[7] * y + warp.R[8] * z;
    const float depth = planes.measured_z[i];
    const float step = depth - block.z[i];
    const float limit = kMaxStep * block.z[i];
    const float measured = depth > 0 ? block.seen[i] : 0;
    block.seen[i] = step <= limit && -step <= limit ? measured : 0;
    block.intensity[i] = planes.nx[i] * (block.x[i] - planes.measured_x[i]) +
                         planes.ny[i] * (block.y[i] - planes.measured_y[i]) - planes.nz[i] * step;
  }
}

/// Sets each point's Jacobian to [n; p x n].
EDVO_INLINE void differentiate(const Planes& planes, Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    block.J[0][i] = planes.nx[i];
    block.J[1][i] = planes.ny[i];
    block.J[2][i] = planes.nz[i];
    block.J[3][i] = block.y[i] * planes.nz[i] - block.z[i] * planes.ny[i];
    block.J[4][i] = block.z[i] * planes.nx[i] - block.x[i] * planes.nz[i];
    block.J[5][i] = block.x[i] * planes.ny[i] - block.y[i] * planes.nx[i];
  }
}

/// Computes the distances, Jacobians and weights of the points from `first` on.
EDVO_INLINE void linearize_block(const DepthView& view, const PassWarp& warp,
                                 const PassOptions& options, std::size_t first, Block& block) {
  const std::size_t count = std::min(kBlock, view.surface.size() - first);
  Planes planes{};
  load_surface(view.surface, first, count, block, planes);
  warp_block(warp, count, block);
  measure(view.image, count, block, planes);
  compare(warp, block, planes);
  differentiate(planes, block);
  weigh_by_loss(options, block);
}

EDVO_TARGET_AVX2 void linearize_avx2(const DepthView& view, const PassWarp& warp,
                                     const PassOptions& options, std::size_t first, Block& block) {
  linearize_block(view, warp, options, first, block);
}

void linearize_baseline(const DepthView& view, const PassWarp& warp, const PassOptions& options,
                        std::size_t first, Block& block) {
  linearize_block(view, warp, options, first, block);
}

/// Returns options that compare distances with nothing: no reference's intensity, no offset.
PassOptions pass_options(double scale) {
  return {.loss = RobustLoss::student_t, .loss_scale = static_cast<float>(scale), .gain = 0};
}

/// Calls `visit(block, count)` for 64 points at a time: all of them, or every `stride`-th block.
template <typename Visit>
void for_each_block(const DepthView& view, const PassOptions& options, Visit visit,
                    std::size_t stride = 1) {
  const PassWarp warp(view.image.camera, view.T_cur_ref);
  const bool is_baseline = available_instruction_set() == InstructionSet::baseline;
  const auto linearize = is_baseline ? linearize_baseline : linearize_avx2;
  Block block{};
  for (std::size_t first = 0; first < view.surface.size(); first += stride * kBlock) {
    linearize(view, warp, options, first, block);
    visit(block, std::min(kBlock, view.surface.size() - first));
  }
}

DepthScore score_of(const Block& block, std::size_t i) {
  DepthScore score{{block.u[i], block.v[i]}, {}};
  for (std::size_t p = 0; p < kPoseParameters; ++p) {
    score.b[static_cast<Eigen::Index>(p)] = block.weight[i] * block.residual[i] * block.J[p][i];
  }
  return score;
}

}  // namespace

NormalEquations<6> linearize_depth(const DepthView& view, double scale) {
  const PassOptions options = pass_options(scale);
  PointEquations sums;
  for_each_block(view, options, [&](Block& block, std::size_t count) {
    LaneSums lanes;
    lanes.add(kPoseParameters, block);
    lanes.flush_into(sums);
    for (std::size_t i = 0; i < count; ++i) {
      sums.points += block.seen[i] > 0 ? 1 : 0;
    }
  });
  sums.complete(view.surface.size(), options);
  return sums.leading<kPoseParameters>();
}

void score_depth(const DepthView& view, double scale, std::vector<DepthScore>& scores) {
  scores.clear();
  for_each_block(view, pass_options(scale), [&](const Block& block, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (block.seen[i] > 0) {
        scores.push_back(score_of(block, i));
      }
    }
  });
}

double distance_spread(const DepthView& view) {
  constexpr std::size_t kEnoughPoints = 600;
  std::array<float, kEnoughPoints + kBlock> magnitudes;
  std::size_t seen = 0;
  const auto keep = [&](const Block& block, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (block.seen[i] > 0) {
        magnitudes[seen++] = std::abs(block.residual[i]);
      }
    }
  };
  for_each_block(view, pass_options(1), keep, 1 + view.surface.size() / kEnoughPoints);
  return robust_sigma_of({magnitudes.data(), seen});
}

void surface_distances(const DepthView& view, std::vector<SurfaceDistance>& distances) {
  distances.clear();
  for_each_block(view, pass_options(1), [&](const Block& block, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (block.seen[i] > 0) {
        distances.push_back({block.z[i], block.residual[i]});
      }
    }
  });
}

double depth_agreement(const DepthView& view) {
  constexpr float kMaxStep = 0.05F;  // share of the depth
  constexpr int kEnoughPoints = 20;
  const PinholeCamera& camera = view.image.camera;
  const Warp<float> warp(camera, view.T_cur_ref);
  int measured = 0;
  int agreeing = 0;
  for (const Eigen::Vector3f& position : view.surface.position) {
    const WarpedPoint<float> point = warp_point<float>(warp, position);
    if (!is_in_view(point, camera)) {
      continue;
    }
    const float depth = view.image.depth(cvRound(point.v), cvRound(point.u));
    if (has_depth(depth)) {
      ++measured;
      agreeing += std::abs(depth - point.p_cur.z()) <= kMaxStep * point.p_cur.z() ? 1 : 0;
    }
  }
  return measured >= kEnoughPoints ? static_cast<double>(agreeing) / measured : 1;
}

}  // namespace vo
