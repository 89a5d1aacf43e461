#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "tools/depth/depth_errors.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/edges/edges.h"
#include "vo/mapping/depth_map.h"

namespace tools {

/// What the first host's depths are.
enum class DepthStart {
  random,  ///< guesses all over the range
  flat,    ///< guesses of one depth
  rgbd,    ///< the depth image
};

constexpr auto enum_names(DepthStart) {
  return std::array{std::pair{DepthStart::random, "random"}, std::pair{DepthStart::flat, "flat"},
                    std::pair{DepthStart::rgbd, "rgbd"}};
}

/// Mapping alone: poses are given.
struct MappingOptions {
  DepthStart start = DepthStart::random;
  double flat_depth = 2;      ///< m
  double rgbd_sigma = 0.01;   ///< relative
  double pose_noise_m = 0;    ///< standard deviation per axis, of every frame's pose
  double pose_noise_deg = 0;  ///< likewise
  std::uint64_t seed = 0;     ///< of random depths and pose noise
  int frames = 0;             ///< at most; 0 is all
  vo::EdgeOptions edges;
  vo::DepthMapOptions map;

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, MappingOptions& options) {
  visit("start", options.start, "the first host keyframe's depths");
  visit("flat_depth", options.flat_depth, "of start=flat, m");
  visit("rgbd_sigma", options.rgbd_sigma, "of start=rgbd, relative");
  visit("pose_noise_m", options.pose_noise_m, "standard deviation per axis of every pose, m");
  visit("pose_noise_deg", options.pose_noise_deg, "likewise, deg");
  visit("seed", options.seed, "of random depths and pose noise");
  visit("frames", options.frames, "at most; 0 is all");
  visit("edges", options.edges, "");
  visit("map", options.map, "");
}

/// What one frame gave.
struct MappedFrame {
  double timestamp = 0;   ///< s
  double baseline_m = 0;  ///< to the host
  bool is_host = false;
  vo::ObservationCounts observations;
  MapErrors errors;
  double mapping_ms = 0;  ///< diagnostic
};

/// Told after each frame: the map, and the true depth of its host.
using MapObserver =
    std::function<void(std::size_t frame, const vo::DepthMap& map, const vo::DepthImage& true_depth,
                       const vo::SE3& T_world_host)>;

/// Maps a sequence with its ground-truth poses. Frames without one are left out.
std::vector<MappedFrame> map_sequence(const vo::SequenceReader& sequence,
                                      const MappingOptions& options, const MapObserver& observe,
                                      const vo::Progress& progress);

/// A relation with pose noise of this standard deviation on both frames, as the map is told it.
vo::FrameRelation noisy_relation(const vo::SE3& T_cur_host, double sigma_m, double sigma_deg);

}  // namespace tools
