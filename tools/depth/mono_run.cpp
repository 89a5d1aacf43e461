#include "tools/depth/mono_run.h"

#include <map>

#include "vo/core/error.h"

namespace tools {
namespace {

/// True depths by the stamp of their image; the last one asked for is kept.
class TrueDepths {
 public:
  explicit TrueDepths(const MonoInput& input)
      : sequence_(input.folder, input.camera, input.max_time_difference) {
    for (std::size_t i = 0; i < sequence_.size(); ++i) {
      index_of_[sequence_.timestamp(i)] = i;
    }
  }

  /// Empty where the image has no depth beside it.
  const vo::DepthImage& at(double timestamp) {
    if (timestamp != timestamp_) {
      const auto found = index_of_.find(timestamp);
      depth_ = found == index_of_.end() ? vo::DepthImage() : sequence_.read(found->second).depth;
      timestamp_ = timestamp;
    }
    return depth_;
  }

 private:
  vo::SequenceReader sequence_;
  std::map<double, std::size_t> index_of_;
  double timestamp_ = -1;
  vo::DepthImage depth_;
};

MappedFrame judged(const vo::MonoOdometry& odometry, const vo::MonoResult& result,
                   const vo::DepthImage& truth, bool metric) {
  MappedFrame mapped{.timestamp = result.tracking.timestamp,
                     .is_anchor = result.tracking.is_keyframe,
                     .observations = result.observations,
                     .mapping_ms = odometry.stage_times().mapping_ms};
  const vo::FrameRelation relation{result.tracking.T_world_camera.inverse() *
                                   odometry.T_world_anchor()};
  mapped.baseline_m = relation.T_cur_anchor.translation().norm();
  mapped.errors = map_errors(odometry.map(), truth, relation, metric ? 1 : 0);
  return mapped;
}

}  // namespace

bool is_metric(vo::MonoBootstrap bootstrap) {
  return bootstrap == vo::MonoBootstrap::rgbd || bootstrap == vo::MonoBootstrap::file;
}

std::vector<MappedFrame> track_and_judge(const MonoInput& input, const vo::MonoOptions& options,
                                         const MapObserver& observe, const vo::Progress& progress) {
  TrueDepths truths(input);
  std::vector<MappedFrame> frames;
  std::size_t index = 0;
  track_mono_sequence(
      input, options,
      [&](const vo::MonoOdometry& odometry, const vo::MonoResult& result) {
        const std::size_t frame = index++;
        if (odometry.map().empty() || result.state != vo::MonoState::tracking) {
          return;
        }
        const vo::DepthImage& truth = truths.at(odometry.map().anchor().timestamp);
        if (truth.empty()) {
          return;
        }
        frames.push_back(judged(odometry, result, truth, is_metric(options.bootstrap)));
        if (observe) {
          observe(frame, odometry.map(), truth, odometry.T_world_anchor());
        }
      },
      progress);
  return frames;
}

}  // namespace tools
