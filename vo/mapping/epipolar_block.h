#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "vo/mapping/epipolar_search.h"
#include "vo/mapping/lane_image.h"
#include "vo/mapping/lane_transform.h"

/// The steps of epipolar_search.cpp for 32 edges at a time, inlined once per instruction set.
namespace vo::detail {

inline constexpr std::size_t kLines = 32;
inline constexpr int kReach = 2;  // samples compared on either side of the edge
inline constexpr std::size_t kCompared = 2 * kReach + 1;
inline constexpr std::size_t kSampled = kCompared + 2;  // samples, one more at either end
inline constexpr float kGreyLevel = 1.0F / 255;
inline constexpr float kMinDepthRatio = 0.1F;   // depth in the current frame over that in the host
inline constexpr double kMaxSearchPx = 60;      // px, longest line that is searched
inline constexpr double kMinParallaxPx = 0.3;   // px, least parallax at the expected depth
inline constexpr double kMinGradient = 2;       // grey levels per 2 px, along the line
inline constexpr double kMinCos2 = 0.3;         // least squared cosine of gradient and line
inline constexpr double kMaxScaleChange = 1.5;  // of the neighbourhood, either way

using LineRow = Lanes<kLines>;
using LineFlags = std::array<std::int32_t, kLines>;     // 0 or 1
using LineOutcomes = std::array<std::int32_t, kLines>;  // SearchOutcome, as wide as a float

constexpr std::int32_t code(SearchOutcome outcome) {
  return static_cast<std::int32_t>(outcome);
}

/// Both images and the geometry between them, in single precision.
struct SearchView {
  const StereoPair& pair;
  const EpipolarOptions& options;
  Projection<float> host_camera, current_camera;
  LaneImage host, current;

  SearchView(const StereoPair& stereo_pair, const EpipolarOptions& search_options)
      : pair(stereo_pair),
        options(search_options),
        host_camera(pair.host.camera),
        current_camera(pair.current.camera),
        host(pair.host.intensity),
        current(pair.current.intensity) {}
};

/// Edges, their epipolar lines in the current image, where s = 0 is the expected place, and the
/// host's intensities along the lines in the host.
struct alignas(64) LineBlock {
  LineRow u, v;                                  // px, edge in the host
  LineRow ray_x, ray_y;                          // X/Z, Y/Z of the edge in the host
  LineRow gradient_u, gradient_v;                // intensity gradient in the host, 1/px
  LineRow inverse_depth, nearest, farthest;      // 1/m, expected and ends of the searched interval
  LaneTransforms<kLines> cur_host;               // of the rows that see the edge
  std::array<LineRow, 3> centre;                 // m, current camera in the host frame
  LineRow towards_x, towards_y;                  // direction of the host's line, in ray coordinates
  LineRow length;                                // px m, length of that direction in the image
  LineRow along_u, along_v;                      // unit direction of the line in the host image
  LineRow cosine, sine;                          // of the angle from line to gradient
  LineRow R_ray_x, R_ray_y, R_ray_z;             // R ray; the point is along R_ray + d t
  LineRow q_x, q_y;                              // ray coordinates of the expected place
  LineRow dq_x, dq_y;                            // ray coordinates per px along the line
  ImagedLanes<kLines> imaged;                    // pixel of q and its derivatives
  LineRow step;                                  // px in the current image per host sample
  LineRow s_min, s_max;                          // px, ends of the searched interval
  LineRow s;                                     // px, place of the match on the line
  LineRow information;                           // sum of squared slopes, per px^2
  LineRow squares;                               // sum of squared differences, less their offset's
  std::array<LineRow, kSampled> host_intensity;  // scaled to the current brightness
  LineOutcomes outcome;
};

/// Sets the outcome to `reason` if the edge fails, unless an earlier step has ruled it out.
EDVO_INLINE void rule_out(bool fails, SearchOutcome reason, std::int32_t& outcome) {
  outcome = (fails & (outcome == code(SearchOutcome::found))) ? code(reason) : outcome;
}

/// Loads one target per lane, where `target_of` gives the target of a lane.
template <typename TargetOf>
EDVO_INLINE void load_targets(const TargetOf& target_of, LineBlock& block) {
  for (std::size_t i = 0; i < kLines; ++i) {
    const SearchTarget& target = target_of(i);
    block.u[i] = static_cast<float>(target.pixel.x);
    block.v[i] = static_cast<float>(target.pixel.y);
    block.ray_x[i] = target.ray[0];
    block.ray_y[i] = target.ray[1];
    block.gradient_u[i] = target.gradient[0];
    block.gradient_v[i] = target.gradient[1];
    block.outcome[i] = code(SearchOutcome::found);
    block.inverse_depth[i] = target.inverse_depth;
    block.nearest[i] = target.nearest;
    block.farthest[i] = target.farthest;
  }
}

/// Finds the geometry between the lines that see each edge. The transforms are rotations to first
/// order in the motion during the read-out.
EDVO_INLINE void place_cameras(const SearchView& view, LineBlock& block) {
  set_transforms(view.pair, block.ray_x, block.ray_y, block.inverse_depth, block.cur_host);
  const auto& [R, t] = block.cur_host;
  for (std::size_t k = 0; k < 3; ++k) {
    LineRow& centre = block.centre[k];
    if (!view.pair.lines.is_rolling) {
      centre.fill(view.pair.p_host_cur[static_cast<Eigen::Index>(k)]);
      continue;
    }
    for (std::size_t i = 0; i < kLines; ++i) {
      centre[i] = -(R[k][i] * t[0][i] + R[3 + k][i] * t[1][i] + R[6 + k][i] * t[2][i]);
    }
  }
}

/// Computes the lines in the host. An edge with too little parallax or too little gradient along
/// its line is unobservable.
EDVO_INLINE void aim_lines(const SearchView& view, LineBlock& block) {
  const auto min_parallax = static_cast<float>(kMinParallaxPx);
  const auto min_gradient = static_cast<float>(kMinGradient) * kGreyLevel;
  const auto min_cos2 = static_cast<float>(kMinCos2);
  ImagedLanes<kLines> imaged;
  image_lanes(view.host_camera, block.ray_x, block.ray_y, imaged);
  for (std::size_t i = 0; i < kLines; ++i) {
    const float x = block.centre[0][i] - block.centre[2][i] * block.ray_x[i];
    const float y = block.centre[1][i] - block.centre[2][i] * block.ray_y[i];
    const float towards_u = imaged.du_dx[i] * x + imaged.du_dy[i] * y;
    const float towards_v = imaged.dv_dx[i] * x + imaged.dv_dy[i] * y;
    const float length = std::sqrt(towards_u * towards_u + towards_v * towards_v);
    block.towards_x[i] = x;
    block.towards_y[i] = y;
    block.length[i] = length;
    block.along_u[i] = towards_u / length;
    block.along_v[i] = towards_v / length;
  }
  for (std::size_t i = 0; i < kLines; ++i) {
    const float gu = block.gradient_u[i];
    const float gv = block.gradient_v[i];
    const double gu2 = static_cast<double>(gu) * static_cast<double>(gu);
    const double gv2 = static_cast<double>(gv) * static_cast<double>(gv);
    const auto norm = static_cast<float>(std::sqrt(gu2 + gv2));
    const float gradient_along = gu * block.along_u[i] + gv * block.along_v[i];
    const float cosine = gradient_along / norm;
    block.cosine[i] = cosine;
    block.sine[i] = (block.along_u[i] * gv - block.along_v[i] * gu) / norm;
    const float gradient = 2 * std::abs(gradient_along);
    const bool observable = (block.length[i] * block.inverse_depth[i] >= min_parallax) &
                            (gradient >= min_gradient) & (cosine * cosine >= min_cos2);
    rule_out(!observable, SearchOutcome::unobservable, block.outcome[i]);
  }
}

/// Computes the points and their neighbours along the line in the current camera. A point behind
/// the camera is unobservable.
EDVO_INLINE void turn_lines(LineBlock& block, LineRow& next_x, LineRow& next_y) {
  const auto& [R, t] = block.cur_host;
  for (std::size_t i = 0; i < kLines; ++i) {
    const float x = block.ray_x[i];
    const float y = block.ray_y[i];
    const float beside_x = x + block.towards_x[i] / block.length[i];
    const float beside_y = y + block.towards_y[i] / block.length[i];
    const float d = block.inverse_depth[i];
    block.R_ray_x[i] = (R[0][i] * x + R[1][i] * y) + R[2][i];
    block.R_ray_y[i] = (R[3][i] * x + R[4][i] * y) + R[5][i];
    block.R_ray_z[i] = (R[6][i] * x + R[7][i] * y) + R[8][i];
    const float z = block.R_ray_z[i] + d * t[2][i];
    const float next_z = ((R[6][i] * beside_x + R[7][i] * beside_y) + R[8][i]) + d * t[2][i];
    block.q_x[i] = (block.R_ray_x[i] + d * t[0][i]) / z;
    block.q_y[i] = (block.R_ray_y[i] + d * t[1][i]) / z;
    next_x[i] = (((R[0][i] * beside_x + R[1][i] * beside_y) + R[2][i]) + d * t[0][i]) / next_z;
    next_y[i] = (((R[3][i] * beside_x + R[4][i] * beside_y) + R[5][i]) + d * t[1][i]) / next_z;
    const bool in_front = (z > kMinDepthRatio) & (next_z > kMinDepthRatio);
    rule_out(!in_front, SearchOutcome::unobservable, block.outcome[i]);
  }
}

/// Computes the lines in the current image. An edge whose scale differs too much is unobservable.
EDVO_INLINE void project_lines(const SearchView& view, LineBlock& block) {
  LineRow next_x;
  LineRow next_y;
  turn_lines(block, next_x, next_y);
  image_lanes(view.current_camera, block.q_x, block.q_y, block.imaged);
  const ImagedLanes<kLines>& imaged = block.imaged;
  const auto limit = static_cast<float>(kMaxScaleChange);
  for (std::size_t i = 0; i < kLines; ++i) {
    const float x = next_x[i] - block.q_x[i];
    const float y = next_y[i] - block.q_y[i];
    const float step_u = imaged.du_dx[i] * x + imaged.du_dy[i] * y;
    const float step_v = imaged.dv_dx[i] * x + imaged.dv_dy[i] * y;
    const float step = std::sqrt(step_u * step_u + step_v * step_v);
    block.step[i] = step;
    block.dq_x[i] = x / step;
    block.dq_y[i] = y / step;
    const bool alike = (step * limit >= 1) & (step <= limit);
    rule_out(!alike, SearchOutcome::unobservable, block.outcome[i]);
  }
}

/// Samples the host along its lines. An edge too near to the host's border is out of view.
EDVO_INLINE void sample_host(const SearchView& view, LineBlock& block) {
  LineRow at_u;
  LineRow at_v;
  for (std::size_t k = 0; k < kSampled; ++k) {
    const auto away = static_cast<float>(static_cast<int>(k) - kReach - 1);
    LineRow& intensity = block.host_intensity[k];
    for (std::size_t i = 0; i < kLines; ++i) {
      at_u[i] = block.u[i] + away * block.along_u[i];
      at_v[i] = block.v[i] + away * block.along_v[i];
    }
    sample_lanes(view.host, at_u, at_v, 0, intensity);
    for (std::size_t i = 0; i < kLines; ++i) {
      intensity[i] = view.pair.gain * intensity[i] + view.pair.offset;
      rule_out(!view.host.bounds.holds(at_u[i], at_v[i]), SearchOutcome::out_of_view,
               block.outcome[i]);
    }
  }
}

/// Returns the place on the line of the point at another inverse depth, px.
EDVO_INLINE float place_of(const LineBlock& block, std::size_t i, float inverse_depth) {
  const auto& t = block.cur_host.t;
  const float x = block.R_ray_x[i] + inverse_depth * t[0][i];
  const float y = block.R_ray_y[i] + inverse_depth * t[1][i];
  const float z = std::max(block.R_ray_z[i] + inverse_depth * t[2][i], kMinDepthRatio);
  const float dq2 = block.dq_x[i] * block.dq_x[i] + block.dq_y[i] * block.dq_y[i];
  return ((x / z - block.q_x[i]) * block.dq_x[i] + (y / z - block.q_y[i]) * block.dq_y[i]) / dq2;
}

/// Computes the ends of the searched interval.
EDVO_INLINE void bound_lines(LineBlock& block) {
  constexpr float kMargin = 0.5F;  // px
  const float half = 0.5F * static_cast<float>(kMaxSearchPx);
  for (std::size_t i = 0; i < kLines; ++i) {
    const float near = place_of(block, i, block.nearest[i]);
    const float far = place_of(block, i, block.farthest[i]);
    block.s_min[i] = std::max(std::min(near, far) - kMargin, -half);
    block.s_max[i] = std::min(std::max(near, far) + kMargin, half);
  }
}

}  // namespace vo::detail
