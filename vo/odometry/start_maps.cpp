#include "vo/odometry/start_maps.h"

#include <cstddef>
#include <vector>

namespace vo {

DepthMap measured_map(const FramePyramid& host, const DepthImage& depth,
                      const MonoOptions& options) {
  constexpr double kMeasuredSigma = 0.01;  // relative
  DepthMap map(options.map);
  map.start(host, options.start_depth);
  map.take_depth(depth, kMeasuredSigma);
  return map;
}

DepthMap guessed_map(const FramePyramid& host, double depth, const MonoOptions& options) {
  DepthMap map(options.map);
  map.start(host, depth);
  if (options.bootstrap == MonoBootstrap::random) {
    map.guess_random(options.seed);
  }
  return map;
}

DepthMap solved_map(const MonoInitialiser& solved, double depth, const MonoOptions& options) {
  constexpr double kInterpolatedSigma = 0.25;  // relative, of depths between corners
  const std::vector<StartFrame>& frames = solved.frames();
  DepthMap map(options.map);
  map.start(frames.front().pyramid, depth);
  map.take_depth(solved.depth_at_edges(), kInterpolatedSigma);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    FrameRelation relation{frames[i].T_frame_first};
    relation.host_motion = ReadoutMotion(frames.front().velocity, solved.readout());
    relation.current_motion = ReadoutMotion(frames[i].velocity, solved.readout());
    map.observe(frames[i].pyramid, relation);
  }
  map.regularise();
  return map;
}

}  // namespace vo
