#include "vo/sequence_odometry/track_mono.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/npy.h"
#include "vo/motion_files/timestamp.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

DepthImage read_depth_file(const fs::path& path, const RgbdCamera& camera) {
  if (path.extension() == ".npy") {
    cv::Mat depth = read_npy(path);
    require(depth.type() == CV_32FC1, path.string(), ": expected one channel, metres");
    require_size(depth, camera.pinhole, path);
    return depth;
  }
  return read_depth_png(path, camera);
}

/// Throws Error where a depth image's median shows another unit than expected.
void check_depth(const fs::path& path, const DepthImage& depth) {
  constexpr double kNearest = 0.05;  // m
  constexpr double kFarthest = 200;  // m
  std::vector<double> values;
  for (const float value : depth) {
    if (std::isfinite(value) && has_depth(value)) {
      values.push_back(value);
    }
  }
  const double median = percentile(values, 0.5);
  require(median >= kNearest && median <= kFarthest, path.string(), ": has a median depth of ",
          median, " m, expected ", kNearest, " to ", kFarthest,
          " m; a PNG is in units of the camera's depth_units_per_m");
}

}  // namespace

SequenceResult MonoSequenceResult::tracking() const {
  SequenceResult result{.frames = {}, .times = times, .trajectory = trajectory};
  for (const MonoResult& frame : frames) {
    result.frames.push_back(frame.tracking);
  }
  return result;
}

double MonoSequenceResult::mapping_ms() const {
  std::vector<double> observed;
  for (const StageTimes& time : times) {
    if (time.mapping_ms > 0) {
      observed.push_back(time.mapping_ms);
    }
  }
  return percentile(observed, 0.5);
}

std::string MonoSequenceResult::why_no_pose() const {
  std::map<std::string, int> counts;
  double parallax_px = 0;
  for (const MonoResult& frame : frames) {
    const bool looked = frame.tracking.reason == TrackingReason::undetermined;
    ++counts[std::string(looked ? to_string(frame.initialiser.verdict)
                                : to_string(frame.tracking.reason))];
    parallax_px = std::max(parallax_px, frame.initialiser.parallax_px);
  }
  std::string text = "no frame has a pose:";
  for (const auto& [reason, count] : counts) {
    text += concat(" ", reason, " ", count, ",");
  }
  return concat(text, " the largest parallax of a start was ", format_real(parallax_px), " px");
}

MonoFrames::MonoFrames(const MonoInput& input, MonoBootstrap bootstrap)
    : sequence_(input.folder, input.camera, input.max_time_difference, SequenceContent::colour,
                input.topics) {
  if (bootstrap == MonoBootstrap::file) {
    require(!input.depth_file.empty(), "mono: expected --depth-file FILE with --bootstrap file");
    first_depth_ = read_depth_file(input.depth_file, sequence_.camera());
    check_depth(input.depth_file, first_depth_);
  } else if (bootstrap == MonoBootstrap::rgbd) {
    const SequenceReader paired(input.folder, input.camera, input.max_time_difference,
                                SequenceContent::colour_and_depth, input.topics);
    const RgbdFrame first = paired.read(0);
    first_depth_ = first.depth;
    while (sequence_.timestamp(first_index_) < first.timestamp) {
      ++first_index_;
    }
  }
  next_index_ = first_index_;
}

std::optional<RgbdFrame> MonoFrames::next() {
  if (next_index_ >= sequence_.size()) {
    return std::nullopt;
  }
  RgbdFrame frame = sequence_.read(next_index_);
  if (next_index_ == first_index_) {
    frame.depth = first_depth_;
  }
  ++next_index_;
  return frame;
}

MonoSequenceResult track_mono_images(const MonoImages& images, const MonoOptions& options,
                                     const MonoObserver& observe, const Progress& progress) {
  MonoOdometry odometry(images.camera, options, images.T_world_first);
  MonoSequenceResult result;
  std::optional<RgbdFrame> next = images.next();
  while (next) {
    const std::optional<RgbdFrame> frame = std::exchange(next, images.next());
    result.frames.push_back(odometry.track(*frame));
    if (!next) {
      result.frames.back() = odometry.finish().value_or(result.frames.back());
    }
    result.times.push_back(odometry.stage_times());
    if (observe) {
      observe(*frame, odometry, result.frames.back());
    }
    progress(result.frames.size(), images.size);
  }
  result.trajectory = odometry.trajectory();
  result.oriented_poses = odometry.poses().count(MonoState::orienting);
  result.scale_uncertain_poses = odometry.poses().count(MonoState::scale_uncertain);
  return result;
}

MonoSequenceResult track_mono_sequence(const MonoInput& input, const MonoOptions& options,
                                       const MonoObserver& observe, const Progress& progress) {
  MonoFrames frames(input, options.bootstrap);
  const RgbdCamera& camera = frames.sequence().camera();
  MonoOptions started = options;
  started.tracker = options.tracker.starting_from(camera);
  MonoSequenceResult result = track_mono_images({.camera = camera.pinhole,
                                                 .T_world_first = {},
                                                 .size = frames.size(),
                                                 .next = [&] { return frames.next(); }},
                                                started, observe, progress);
  result.sequence_notes = frames.sequence().notes();
  return result;
}

std::string format_mono_log(const std::vector<MonoResult>& frames) {
  std::string text =
      "timestamp,state,status,reason,keyframe,start_verdict,start_flow_px,start_parallax_px,"
      "hypotheses,confident,found,inconsistent,out_of_view,unobservable,ambiguous,no_match,"
      "visible_fraction,correlation,cost,readout_s,readout_axis,scale_drift,scale_sigma,joins_"
      "maps\n";
  for (const MonoResult& frame : frames) {
    const TrackingResult& tracking = frame.tracking;
    const ObservationCounts& seen = frame.observations;
    text += concat(format_timestamp(tracking.timestamp), ",", to_string(frame.state), ",",
                   to_string(tracking.status), ",", to_string(tracking.reason), ",",
                   tracking.is_keyframe ? 1 : 0, ",", to_string(frame.initialiser.verdict));
    for (const double value : {frame.initialiser.flow_px, frame.initialiser.parallax_px}) {
      text += "," + format_real(value);
    }
    for (const std::size_t count :
         {frame.hypotheses, frame.confident, seen.found, seen.inconsistent, seen.out_of_view,
          seen.unobservable, seen.ambiguous, seen.no_match}) {
      text += "," + std::to_string(count);
    }
    for (const double value : {tracking.alignment.visible_fraction, tracking.alignment.correlation,
                               tracking.alignment.cost, tracking.readout.seconds}) {
      text += "," + format_real(value);
    }
    text += concat(",", to_string(tracking.readout.axis));
    for (const double value : {frame.scale.drift, frame.scale.sigma}) {
      text += "," + format_real(value);
    }
    text += frame.joins_maps ? ",1\n" : ",0\n";
  }
  return text;
}

}  // namespace vo
