#include "vo/mapping/moved_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>

#include "vo/mapping/lane_image.h"
#include "vo/mapping/lane_transform.h"

namespace vo {
namespace {

constexpr std::size_t kEdges = 32;

using detail::ImagedLanes;
using detail::LaneImage;
using detail::sample_lanes;
using detail::set_transforms;
using Row = detail::Lanes<kEdges>;
using Transforms = detail::LaneTransforms<kEdges>;

/// The images, the hypotheses and the geometry that all edges share.
struct MoveView {
  const StereoPair& pair;
  const Hypotheses& hypotheses;
  float relative_noise;
  Projection<float> camera;
  LaneImage host, current;

  MoveView(const StereoPair& stereo_pair, const Hypotheses& edges, float noise)
      : pair(stereo_pair),
        hypotheses(edges),
        relative_noise(noise),
        camera(pair.current.camera),
        host(pair.host.intensity),
        current(pair.current.intensity) {}
};

struct alignas(64) Block {
  Row u, v, across_u, across_v;                       // px, edge in the host; unit, its gradient
  Row gradient2;                                      // 1/px^2
  Row inverse_depth, variance;                        // 1/m, 1/m^2
  Row moved_depth, moved_variance;                    // 1/m, 1/m^2
  Row position_u, position_v;                         // px
  Row direction_u, direction_v;                       // unit
  std::array<std::int32_t, kEdges> visible, changed;  // 0 or 1
};

void load(const MoveView& view, std::span<const std::size_t> indices, Block& block) {
  const Hypotheses& hypotheses = view.hypotheses;
  for (std::size_t lane = 0; lane < kEdges; ++lane) {
    const std::size_t i = indices[std::min(lane, indices.size() - 1)];
    const cv::Vec2f edge = hypotheses.edge_position(i);
    const cv::Vec2f& gradient = hypotheses.gradient[i];
    block.u[lane] = edge[0];
    block.v[lane] = edge[1];
    block.across_u[lane] = hypotheses.across[i][0];
    block.across_v[lane] = hypotheses.across[i][1];
    block.gradient2[lane] = gradient[0] * gradient[0] + gradient[1] * gradient[1];
    block.inverse_depth[lane] = hypotheses.inverse_depth[i];
    block.variance[lane] = hypotheses.variance[i];
  }
}

/// The rays of two neighbouring pixels in a row, per edge.
using RayRow = std::array<float, 4 * kEdges>;

/// Interpolates the rays of positions between pixels.
EDVO_INLINE void find_rays(const RayImage& rays, const Row& u, const Row& v, Row& x, Row& y) {
  std::array<int, kEdges> u0;
  std::array<int, kEdges> v0;
  for (std::size_t i = 0; i < kEdges; ++i) {
    u0[i] = std::min(std::max(static_cast<int>(u[i]), 0), rays.cols - 2);
    v0[i] = std::min(std::max(static_cast<int>(v[i]), 0), rays.rows - 2);
  }
  RayRow upper;
  RayRow lower;
  for (std::size_t i = 0; i < kEdges; ++i) {
    const auto* above = reinterpret_cast<const float*>(rays[v0[i]]) + 2 * u0[i];
    const auto* below = reinterpret_cast<const float*>(rays[v0[i] + 1]) + 2 * u0[i];
    std::memcpy(upper.data() + 4 * i, above, 4 * sizeof(float));
    std::memcpy(lower.data() + 4 * i, below, 4 * sizeof(float));
  }
  for (std::size_t i = 0; i < kEdges; ++i) {
    const float du = u[i] - static_cast<float>(u0[i]);
    const float dv = v[i] - static_cast<float>(v0[i]);
    const float above_x = upper[4 * i] * (1 - du) + upper[4 * i + 2] * du;
    const float above_y = upper[4 * i + 1] * (1 - du) + upper[4 * i + 3] * du;
    const float below_x = lower[4 * i] * (1 - du) + lower[4 * i + 2] * du;
    const float below_y = lower[4 * i + 1] * (1 - du) + lower[4 * i + 3] * du;
    x[i] = above_x * (1 - dv) + below_x * dv;
    y[i] = above_y * (1 - dv) + below_y * dv;
  }
}

/// Points of the host in the current camera's frame, divided by their depth in the host, and their
/// pixels in the current image.
struct MovedPlaces {
  Row z;
  ImagedLanes<kEdges> imaged;
};

/// Moves the points of rays (x, y); the rays become those in the current camera.
EDVO_INLINE void move_places(const MoveView& view, const Transforms& cur_host,
                             const Row& inverse_depth, Row& x, Row& y, MovedPlaces& places) {
  const auto& [R, t] = cur_host;
  for (std::size_t i = 0; i < kEdges; ++i) {
    const float d = inverse_depth[i];
    const float p_x = ((R[0][i] * x[i] + R[1][i] * y[i]) + R[2][i]) + d * t[0][i];
    const float p_y = ((R[3][i] * x[i] + R[4][i] * y[i]) + R[5][i]) + d * t[1][i];
    const float p_z = ((R[6][i] * x[i] + R[7][i] * y[i]) + R[8][i]) + d * t[2][i];
    places.z[i] = p_z;
    x[i] = p_x / p_z;
    y[i] = p_y / p_z;
  }
  detail::image_lanes(view.camera, x, y, places.imaged);
}

/// Moves the edges and the places one pixel beside them, along their gradients.
EDVO_INLINE void move_edges_and_besides(const MoveView& view, const Block& block,
                                        Transforms& cur_host, MovedPlaces& edge,
                                        MovedPlaces& beside) {
  Row beside_u;
  Row beside_v;
  for (std::size_t i = 0; i < kEdges; ++i) {
    beside_u[i] = block.u[i] + block.across_u[i];
    beside_v[i] = block.v[i] + block.across_v[i];
  }
  Row x;
  Row y;
  find_rays(view.pair.host.rays, block.u, block.v, x, y);
  set_transforms(view.pair, x, y, block.inverse_depth, cur_host);
  move_places(view, cur_host, block.inverse_depth, x, y, edge);
  find_rays(view.pair.host.rays, beside_u, beside_v, x, y);
  move_places(view, cur_host, block.inverse_depth, x, y, beside);
}

EDVO_INLINE void move_block(const MoveView& view, Block& block) {
  constexpr float kMinDepthRatio = 0.01F;
  Transforms cur_host;
  MovedPlaces edge;
  MovedPlaces beside;
  move_edges_and_besides(view, block, cur_host, edge, beside);
  for (std::size_t i = 0; i < kEdges; ++i) {
    const float z = edge.z[i];
    const float d = block.inverse_depth[i] / z;
    const float growth = (z - block.inverse_depth[i] * cur_host.t[2][i]) / (z * z);
    const float noise = view.relative_noise * d;
    const float u = beside.imaged.u[i] - edge.imaged.u[i];
    const float v = beside.imaged.v[i] - edge.imaged.v[i];
    const float length = std::sqrt(u * u + v * v);
    const bool is_ahead = (z > kMinDepthRatio) & (beside.z[i] > kMinDepthRatio);
    const bool is_inside = view.current.bounds.holds(edge.imaged.u[i], edge.imaged.v[i]);
    block.moved_depth[i] = d;
    block.moved_variance[i] = growth * growth * block.variance[i] + noise * noise;
    block.position_u[i] = edge.imaged.u[i];
    block.position_v[i] = edge.imaged.v[i];
    block.direction_u[i] = length > 0 ? u / length : 0;
    block.direction_v[i] = length > 0 ? v / length : 0;
    block.visible[i] = (is_ahead & is_inside & (d > 0)) ? 1 : 0;
  }
}

/// Marks edges of changed intensity. The bound is that of LSD-SLAM: 40 grey levels, more on strong
/// gradients.
EDVO_INLINE void compare_block(const MoveView& view, Block& block) {
  constexpr float kMaxDifference = 40.0F / 255;
  Row before;
  Row now;
  sample_lanes(view.host, block.u, block.v, 0, before);
  sample_lanes(view.current, block.position_u, block.position_v, 0, now);
  for (std::size_t i = 0; i < kEdges; ++i) {
    const float difference = now[i] - (view.pair.gain * before[i] + view.pair.offset);
    const float slope = 2 * std::sqrt(block.gradient2[i]);
    block.changed[i] =
        difference * difference > kMaxDifference * kMaxDifference + 0.25F * slope * slope ? 1 : 0;
  }
}

EDVO_INLINE void move_all(const MoveView& view, std::span<const std::size_t> known,
                          std::vector<MovedEdge>& edges) {
  Block block;
  for (std::size_t first = 0; first < known.size(); first += kEdges) {
    const auto some = known.subspan(first, std::min(kEdges, known.size() - first));
    load(view, some, block);
    move_block(view, block);
    compare_block(view, block);
    for (std::size_t i = 0; i < some.size(); ++i) {
      edges.push_back({some[i],
                       block.visible[i] > 0,
                       block.changed[i] > 0,
                       block.moved_depth[i],
                       block.moved_variance[i],
                       {block.position_u[i], block.position_v[i]},
                       {block.direction_u[i], block.direction_v[i]}});
    }
  }
}

void move_baseline(const MoveView& view, std::span<const std::size_t> known,
                   std::vector<MovedEdge>& edges) {
  move_all(view, known, edges);
}

EDVO_TARGET_AVX2 void move_avx2(const MoveView& view, std::span<const std::size_t> known,
                                std::vector<MovedEdge>& edges) {
  move_all(view, known, edges);
}

}  // namespace

std::vector<MovedEdge> move_edges(const StereoPair& pair, const Hypotheses& hypotheses,
                                  float relative_noise, InstructionSet set) {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.state[i] != DepthState::none) {
      known.push_back(i);
    }
  }
  std::vector<MovedEdge> edges;
  edges.reserve(known.size());
  const MoveView view(pair, hypotheses, relative_noise);
  if (set == InstructionSet::baseline) {
    move_baseline(view, known, edges);
  } else {
    move_avx2(view, known, edges);
  }
  return edges;
}

}  // namespace vo
