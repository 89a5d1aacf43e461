#include "tools/depth/mono_run.h"

namespace tools {

MapJudge::MapJudge(const vo::SequenceReader& truth, vo::MonoBootstrap bootstrap, double depth_noise)
    : truth_(truth), is_metric_(is_metric(bootstrap)), depth_noise_(depth_noise) {
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    index_of_[truth_.timestamp(i)] = i;
  }
}

void MapJudge::read_truth(double timestamp) {
  if (timestamp == timestamp_) {
    return;
  }
  const auto found = index_of_.find(timestamp);
  host_ = found == index_of_.end() ? TrueView()
                                   : TrueView{truth_.read(found->second).depth,
                                              true_edges(truth_, found->second), depth_noise_};
  timestamp_ = timestamp;
}

std::optional<MappedFrame> MapJudge::judge(const vo::MonoOdometry& odometry,
                                           const vo::MonoResult& result) {
  if (odometry.map().empty() || !vo::is_in_map(result.state)) {
    return std::nullopt;
  }
  read_truth(odometry.map().host().timestamp);
  if (host_.depth.empty()) {
    return std::nullopt;
  }
  MappedFrame mapped{.timestamp = result.tracking.timestamp,
                     .is_host = result.tracking.is_keyframe,
                     .observations = result.observations,
                     .mapping_ms = odometry.stage_times().mapping_ms};
  const vo::FrameRelation relation{result.tracking.T_world_camera.inverse() *
                                   odometry.T_world_host()};
  mapped.baseline_m = relation.T_cur_host.translation().norm();
  mapped.errors = map_errors(odometry.map(), host_, relation, is_metric_ ? 1 : 0);
  return mapped;
}

std::vector<MappedFrame> track_and_judge(const vo::MonoInput& input, const vo::MonoOptions& options,
                                         double depth_noise, const MapObserver& observe,
                                         const vo::Progress& progress) {
  const vo::SequenceReader truth(input.folder, input.camera, input.max_time_difference,
                                 vo::SequenceContent::colour_and_depth, input.topics);
  MapJudge judge(truth, options.bootstrap, depth_noise);
  std::vector<MappedFrame> frames;
  std::size_t index = 0;
  vo::track_mono_sequence(
      input, options,
      [&](const vo::RgbdFrame&, const vo::MonoOdometry& odometry, const vo::MonoResult& result) {
        const std::size_t frame = index++;
        if (const std::optional<MappedFrame> mapped = judge.judge(odometry, result)) {
          frames.push_back(*mapped);
          if (observe) {
            observe(frame, odometry.map(), judge.true_depth(), odometry.T_world_host());
          }
        }
      },
      progress);
  return frames;
}

}  // namespace tools
