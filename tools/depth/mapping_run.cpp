#include "tools/depth/mapping_run.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "vo/core/error.h"
#include "vo/core/hash.h"
#include "vo/core/stopwatch.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {
namespace {

constexpr double kFlatDepth = 2;     ///< m, depth of a flat start
constexpr double kRgbdSigma = 0.01;  ///< relative standard deviation of depths of an RGB-D start

/// Returns a standard normal variate (Box & Muller) that is a function of seed and index.
double normal(std::uint64_t seed, std::uint64_t index) {
  const auto uniform = [&](std::uint64_t stream) {
    const std::uint64_t bits = vo::mixed(vo::mixed(vo::mixed(seed) + index) + stream);
    return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53;
  };
  return std::sqrt(-2 * std::log(uniform(0))) * std::cos(2 * std::numbers::pi * uniform(1));
}

vo::SE3 with_noise(const vo::SE3& T_world_camera, const MappingOptions& options,
                   std::size_t frame) {
  if (options.pose_noise_m == 0 && options.pose_noise_deg == 0) {
    return T_world_camera;
  }
  vo::Vector6d error;
  for (int k = 0; k < 6; ++k) {
    const double sigma =
        k < 3 ? options.pose_noise_m : options.pose_noise_deg * std::numbers::pi / 180;
    error[k] = sigma * normal(options.seed, 6 * frame + static_cast<std::uint64_t>(k));
  }
  return T_world_camera * vo::SE3::exp(error);
}

/// Returns the motion while an image was read, by the mean velocity over a frame's time around it.
/// There is none at the ends of the trajectory.
vo::ReadoutMotion readout_motion(const vo::Trajectory& truth, double timestamp,
                                 const vo::Readout& readout) {
  constexpr double kHalfFrame = 1.0 / 60;  // s
  const std::optional<vo::SE3> T_world_before = vo::pose_at(truth, timestamp - kHalfFrame);
  const std::optional<vo::SE3> T_world_after = vo::pose_at(truth, timestamp + kHalfFrame);
  if (!readout.is_rolling() || !T_world_before || !T_world_after) {
    return {};
  }
  const vo::SE3 T_before_after = T_world_before->inverse() * *T_world_after;
  return {T_before_after.log() / (2 * kHalfFrame), readout};
}

/// A frame's pose and the motion while it was read.
struct FramePose {
  vo::SE3 T_world_camera;
  vo::ReadoutMotion readout_motion;
};

vo::PyramidOptions single_level() {
  vo::PyramidOptions options;
  options.levels = 1;
  return options;
}

/// Maintains one depth map over a sequence with given poses.
class MappingRun {
 public:
  MappingRun(const vo::SequenceReader& sequence, const MappingOptions& options)
      : sequence_(sequence),
        camera_(sequence.camera().pinhole),
        options_(options),
        pyramid_builder_(camera_, single_level()),
        finder_(options.edges),
        map_(options.map) {}

  MappedFrame add(const vo::RgbdFrame& frame, std::size_t index, const FramePose& pose) {
    vo::FramePyramid pyramid;
    pyramid_builder_.build({frame.timestamp, frame.image, {}}, {}, pyramid);
    vo::add_edges(pyramid, finder_);
    MappedFrame mapped{.timestamp = frame.timestamp};
    if (map_.empty()) {
      start(pyramid, frame.depth);
      set_host(frame.depth, index, pose);
      mapped.is_host = true;
      mapped.errors = map_errors(map_, truth_, {});
      return mapped;
    }
    vo::FrameRelation relation =
        noisy_relation(pose.T_world_camera.inverse() * host_pose_.T_world_camera,
                       options_.pose_noise_m, options_.pose_noise_deg);
    relation.host_motion = host_pose_.readout_motion;
    relation.current_motion = pose.readout_motion;
    mapped.baseline_m = relation.T_cur_host.translation().norm();
    const vo::CpuStopwatch observing;
    mapped.observations = map_.observe(pyramid, relation);
    map_.regularise();
    mapped.mapping_ms = observing.elapsed_ms();
    mapped.errors = map_errors(map_, truth_, relation);
    const vo::CpuStopwatch moving;
    if (map_.needs_new_host(pyramid, relation.T_cur_host)) {
      map_.propagate(pyramid, relation);
      map_.regularise();
      set_host(frame.depth, index, pose);
      mapped.is_host = true;
    }
    mapped.mapping_ms += moving.elapsed_ms();
    return mapped;
  }

  const vo::DepthMap& map() const { return map_; }
  const vo::DepthImage& true_depth() const { return truth_.depth; }
  const vo::SE3& T_world_host() const { return host_pose_.T_world_camera; }

 private:
  void start(const vo::FramePyramid& pyramid, const vo::DepthImage& depth) {
    map_.start(pyramid, kFlatDepth);
    if (options_.start == DepthStart::random) {
      map_.guess_random(options_.seed);
    } else if (options_.start == DepthStart::rgbd) {
      map_.take_depth(depth, kRgbdSigma);
    }
  }

  void set_host(const vo::DepthImage& depth, std::size_t index, const FramePose& pose) {
    truth_ = {depth, true_edges(sequence_, index), options_.depth_noise};
    host_pose_ = pose;
  }

  const vo::SequenceReader& sequence_;
  vo::PinholeCamera camera_;
  const MappingOptions& options_;
  vo::PyramidBuilder pyramid_builder_;
  vo::EdgeFinder finder_;
  vo::DepthMap map_;
  TrueView truth_;  ///< ground truth of the host
  FramePose host_pose_;
};

}  // namespace

void MappingOptions::validate() const {
  vo::require(pose_noise_m >= 0 && pose_noise_deg >= 0, "depth: expected pose noise of at least 0");
  vo::require(std::abs(readout.seconds) <= 1, "depth.readout: expected a time of at most 1 s, got ",
              readout.seconds);
  vo::require(depth_noise >= 0, "depth.depth_noise: expected at least 0, got ", depth_noise);
  vo::require(frames >= 0, "depth.frames: expected at least 0, got ", frames);
  edges.validate();
  map.validate();
}

vo::FrameRelation noisy_relation(const vo::SE3& T_cur_host, double sigma_m, double sigma_deg) {
  vo::FrameRelation relation{T_cur_host};
  const double sigma_rad = sigma_deg * std::numbers::pi / 180;
  relation.covariance.diagonal() << vo::Vector6d::Constant(2);
  relation.covariance.topLeftCorner<3, 3>() *= sigma_m * sigma_m;
  relation.covariance.bottomRightCorner<3, 3>() *= sigma_rad * sigma_rad;
  return relation;
}

double median_mapping_ms(const std::vector<MappedFrame>& frames) {
  std::vector<double> times;
  for (const MappedFrame& frame : frames) {
    times.push_back(frame.mapping_ms);
  }
  return vo::percentile(times, 0.5);
}

std::vector<MappedFrame> map_sequence(const vo::SequenceReader& sequence,
                                      const MappingOptions& options, const MapObserver& observe,
                                      const vo::Progress& progress) {
  const vo::Trajectory& truth = sequence.ground_truth();
  vo::require(!truth.empty(),
              "depth: the sequence has no groundtruth.txt, expected poses to map with");
  MappingRun run(sequence, options);
  vo::FrameStream stream(sequence);
  std::vector<MappedFrame> frames;
  const std::size_t last =
      options.frames > 0 ? static_cast<std::size_t>(options.frames) : sequence.size();
  for (std::size_t i = 0; i < last; ++i) {
    const std::optional<vo::RgbdFrame> frame = stream.next();
    if (!frame) {
      break;
    }
    const std::optional<vo::SE3> T_world_camera = vo::pose_at(truth, frame->timestamp);
    if (T_world_camera) {
      frames.push_back(run.add(*frame, i,
                               {with_noise(*T_world_camera, options, i),
                                readout_motion(truth, frame->timestamp, options.readout)}));
      if (observe) {
        observe(i, run.map(), run.true_depth(), run.T_world_host());
      }
    }
    progress(i + 1, last);
  }
  return frames;
}

}  // namespace tools
