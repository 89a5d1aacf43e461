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

/// How the first host keyframe's depths are initialised.
enum class DepthStart {
  random,  ///< random depths over the whole range
  flat,    ///< one constant depth
  rgbd,    ///< depths of the depth image
};

constexpr auto enum_names(DepthStart) {
  return std::array{std::pair{DepthStart::random, "random"}, std::pair{DepthStart::flat, "flat"},
                    std::pair{DepthStart::rgbd, "rgbd"}};
}

/// Options of mapping with given poses.
struct MappingOptions {
  DepthStart start = DepthStart::random;
  double pose_noise_m = 0;    ///< standard deviation of translation per axis
  double pose_noise_deg = 0;  ///< standard deviation of rotation per axis
  std::uint64_t seed = 0;     ///< seed of random depths and pose noise
  vo::Readout readout;        ///< rolling shutter's read-out
  double depth_noise = 0;     ///< 1/m, standard deviation of the sequence's inverse depths
  int frames = 0;             ///< greatest number of frames; 0 = all
  vo::EdgeOptions edges;
  vo::DepthMapOptions map;

  void validate() const;  ///< throws vo::Error on an invalid option
};

template <typename Visitor>
void visit_fields(Visitor& visit, MappingOptions& options) {
  visit("start", options.start, "the first host keyframe's depths");
  visit("pose_noise_m", options.pose_noise_m, "standard deviation per axis of every pose, m");
  visit("pose_noise_deg", options.pose_noise_deg, "likewise, deg");
  visit("seed", options.seed, "of random depths and pose noise");
  visit("readout", options.readout.seconds,
        "time from the first to the last line, s, negative where the last is read first: a rolling "
        "shutter");
  visit("readout_axis", options.readout.axis, "which lines a rolling shutter reads");
  visit("depth_noise", options.depth_noise,
        "standard deviation of the sequence's own inverse depths, which the NEES allows for, 1/m");
  visit("frames", options.frames, "at most; 0 is all");
  visit("edges", options.edges, "");
  visit("map", options.map, "");
}

/// Results of mapping one frame.
struct MappedFrame {
  double timestamp = 0;   ///< s
  double baseline_m = 0;  ///< distance to the host keyframe
  bool is_host = false;
  vo::ObservationCounts observations;
  MapErrors errors;
  double mapping_ms = 0;  ///< processor time of mapping; diagnostic
};

double median_mapping_ms(const std::vector<MappedFrame>& frames);

/// Called after each frame with the map and the true depth of its host.
using MapObserver =
    std::function<void(std::size_t frame, const vo::DepthMap& map, const vo::DepthImage& true_depth,
                       const vo::SE3& T_world_host)>;

/// Maps a sequence with its ground-truth poses; frames without a pose are left out. Throws
/// vo::Error without ground truth.
std::vector<MappedFrame> map_sequence(const vo::SequenceReader& sequence,
                                      const MappingOptions& options, const MapObserver& observe,
                                      const vo::Progress& progress);

/// Returns a relation whose covariance is that of independent pose noise on both frames.
vo::FrameRelation noisy_relation(const vo::SE3& T_cur_host, double sigma_m, double sigma_deg);

}  // namespace tools
