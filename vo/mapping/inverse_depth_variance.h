#pragma once

#include <cmath>
#include <cstddef>

#include "vo/mapping/epipolar_block.h"

/// Inverse depths of a block's matches and their variances.
namespace vo::detail {

struct LineVariance {
  LineRow inverse_depth;  // 1/m
  LineRow variance;       // 1/m^2
  LineRow offset_slope;   // 1/m
};

/// The points at the matches in the current camera's frame, divided by their depth in the host.
struct LinePoints {
  LineRow inverse_depth;  // 1/m
  LineRow x, y, z;
};

/// Triangulates the matches. A point behind the camera has no match.
EDVO_INLINE void triangulate_lines(LineBlock& block, LinePoints& points) {
  const auto& t = block.cur_host.t;
  for (std::size_t i = 0; i < kLines; ++i) {
    const float dq_x = block.dq_x[i];
    const float dq_y = block.dq_y[i];
    const bool by_x = std::abs(dq_x) > std::abs(dq_y);
    const float q = by_x ? block.q_x[i] + block.s[i] * dq_x : block.q_y[i] + block.s[i] * dq_y;
    const float R_ray = by_x ? block.R_ray_x[i] : block.R_ray_y[i];
    const float along = by_x ? t[0][i] : t[1][i];
    const float d = (R_ray - q * block.R_ray_z[i]) / (q * t[2][i] - along);
    rule_out(!(d > 0), SearchOutcome::no_match, block.outcome[i]);
    points.inverse_depth[i] = d;
    points.x[i] = block.R_ray_x[i] + d * t[0][i];
    points.y[i] = block.R_ray_y[i] + d * t[1][i];
    points.z[i] = block.R_ray_z[i] + d * t[2][i];
  }
}

/// Derivatives of points' positions across their edges by the pose increment, px.
using PoseSlopes = std::array<LineRow, 6>;

EDVO_INLINE void differentiate_lines(const SearchView& view, const LineBlock& block,
                                     const LinePoints& points, PoseSlopes& slopes) {
  LineRow ray_x;
  LineRow ray_y;
  for (std::size_t i = 0; i < kLines; ++i) {
    ray_x[i] = points.x[i] / points.z[i];
    ray_y[i] = points.y[i] / points.z[i];
  }
  ImagedLanes<kLines> J;
  image_lanes(view.current_camera, ray_x, ray_y, J);
  for (std::size_t i = 0; i < kLines; ++i) {
    const float line_u = J.du_dx[i] * block.dq_x[i] + J.du_dy[i] * block.dq_y[i];
    const float line_v = J.dv_dx[i] * block.dq_x[i] + J.dv_dy[i] * block.dq_y[i];
    const float length = std::sqrt(line_u * line_u + line_v * line_v);
    const float along_u = line_u / length;
    const float along_v = line_v / length;
    const float across_u = block.cosine[i] * along_u - block.sine[i] * along_v;
    const float across_v = block.cosine[i] * along_v + block.sine[i] * along_u;
    const float by_x = (J.du_dx[i] * across_u + J.dv_dx[i] * across_v) / points.z[i];
    const float by_y = (J.du_dy[i] * across_u + J.dv_dy[i] * across_v) / points.z[i];
    const float by_z = -(by_x * ray_x[i] + by_y * ray_y[i]);
    slopes[0][i] = points.inverse_depth[i] * by_x;
    slopes[1][i] = points.inverse_depth[i] * by_y;
    slopes[2][i] = points.inverse_depth[i] * by_z;
    slopes[3][i] = points.y[i] * by_z - points.z[i] * by_y;
    slopes[4][i] = points.z[i] * by_x - points.x[i] * by_z;
    slopes[5][i] = points.x[i] * by_y - points.y[i] * by_x;
  }
}

/// Computes the variance, px^2, that the pose's error gives the points' positions across their
/// edges. Sums are in the order of Eigen's products.
EDVO_INLINE void vary_poses(const SearchView& view, const LineBlock& block,
                            const LinePoints& points, LineRow& variance) {
  if (view.pair.pose_is_exact) {
    variance.fill(0);
    return;
  }
  PoseSlopes p;
  differentiate_lines(view, block, points, p);
  const Eigen::Matrix<float, 6, 6>& C = view.pair.covariance;
  PoseSlopes terms;
  for (int r = 0; r < 6; ++r) {
    const auto row = static_cast<std::size_t>(r);
    for (std::size_t i = 0; i < kLines; ++i) {
      const float t0 = C(r, 0) * p[0][i];
      const float t1 = C(r, 1) * p[1][i];
      const float t2 = C(r, 2) * p[2][i];
      const float t3 = C(r, 3) * p[3][i];
      const float t4 = C(r, 4) * p[4][i];
      const float t5 = C(r, 5) * p[5][i];
      const float sum = r < 4 ? t0 + t1 + t2 + t3 + t4 + t5 : (t0 + (t1 + t2)) + (t3 + (t4 + t5));
      terms[row][i] = p[row][i] * sum;
    }
  }
  for (std::size_t i = 0; i < kLines; ++i) {
    variance[i] =
        ((terms[0][i] + terms[2][i]) + (terms[1][i] + terms[3][i])) + (terms[4][i] + terms[5][i]);
  }
}

EDVO_INLINE void judge_lines(const SearchView& view, LineBlock& block,
                             LineVariance& line_variance) {
  const auto sigma_offset = static_cast<float>(view.options.sigma_offset_px);
  const auto sigma_line = static_cast<float>(view.options.sigma_line_px);
  const auto sigma_match = static_cast<float>(view.options.sigma_match_px);
  const auto sigma_grey = static_cast<float>(view.options.sigma_grey) * kGreyLevel;
  const auto& t = block.cur_host.t;
  LinePoints points;
  triangulate_lines(block, points);
  LineRow pose_variance;
  vary_poses(view, block, points, pose_variance);
  for (std::size_t i = 0; i < kLines; ++i) {
    const float z = points.z[i];
    const float dq_x = block.dq_x[i];
    const float dq_y = block.dq_y[i];
    const float by_d_x = (t[0][i] * z - points.x[i] * t[2][i]) / (z * z);
    const float by_d_y = (t[1][i] * z - points.y[i] * t[2][i]) / (z * z);
    const float px_per_inverse_depth =
        (by_d_x * dq_x + by_d_y * dq_y) / (dq_x * dq_x + dq_y * dq_y);
    const float across = sigma_line * sigma_line + pose_variance[i];
    const float noise = 0.5F * (2 * sigma_grey * sigma_grey + block.squares[i] / (kCompared - 1));
    const float variance_px = across / (block.cosine[i] * block.cosine[i]) +
                              noise / block.information[i] + sigma_match * sigma_match;
    const float offset_px = sigma_offset * block.step[i] / block.cosine[i];
    line_variance.inverse_depth[i] = points.inverse_depth[i];
    line_variance.variance[i] = variance_px / (px_per_inverse_depth * px_per_inverse_depth);
    line_variance.offset_slope[i] = offset_px / px_per_inverse_depth;
  }
}

}  // namespace vo::detail
