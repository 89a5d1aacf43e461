#include "vo/sequence_odometry/track_sequence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/median.h"
#include "vo/motion_files/timestamp.h"
#include "vo/sequence_odometry/track_frames.h"

namespace vo {
namespace {

template <typename Stage>
std::vector<double> stage(const std::vector<StageTimes>& times, Stage select) {
  std::vector<double> values;
  for (const StageTimes& time : times) {
    values.push_back(select(time));
  }
  return values;
}

/// Returns the median of every 16th depth in every 16th row, or 0 without any.
float median_depth(const DepthImage& depth) {
  constexpr int kStep = 16;  // px
  std::vector<float> depths;
  for (int v = kStep / 2; v < depth.rows; v += kStep) {
    for (int u = kStep / 2; u < depth.cols; u += kStep) {
      if (has_depth(depth(v, u))) {
        depths.push_back(depth(v, u));
      }
    }
  }
  return depths.empty() ? 0 : upper_median(std::move(depths));
}

double rounded_cm(double meters) {
  return std::round(100 * meters) / 100;
}

std::string covariance_titles(const std::string& name) {
  const std::array names{"tx", "ty", "tz", "rx", "ry", "rz"};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i; j < names.size(); ++j) {
      text += concat(",", name, "_", names.at(i), "_", names.at(j));
    }
  }
  return text;
}

std::string frame_log_header() {
  std::string text =
      "timestamp,status,reason,keyframe,termination,iterations,points,visible_fraction,correlation,"
      "depth_agreement,depth_deviation,cost,conditioning,noise_share,readout_s,readout_axis,"
      "vignette_2,vignette_4,"
      "moving_fraction";
  return text + ",reference_timestamp" + covariance_titles("covariance") +
         covariance_titles("absolute_covariance") + "\n";
}

/// Returns the upper triangle row by row.
std::string covariance_values(const Matrix6d& covariance) {
  std::string text;
  for (int i = 0; i < covariance.rows(); ++i) {
    for (int j = i; j < covariance.cols(); ++j) {
      text += "," + format_real(covariance(i, j));
    }
  }
  return text;
}

}  // namespace

double percentile(std::vector<double> values, double fraction) {
  if (values.empty()) {
    return 0;
  }
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(fraction * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

double SequenceResult::tracked_fraction() const {
  return frames.empty()
             ? 0
             : static_cast<double>(trajectory.size()) / static_cast<double>(frames.size());
}

std::size_t SequenceResult::keyframes() const {
  return static_cast<std::size_t>(std::count_if(
      frames.begin(), frames.end(), [](const TrackingResult& f) { return f.is_keyframe; }));
}

std::size_t SequenceResult::beginnings() const {
  return static_cast<std::size_t>(std::count_if(
      frames.begin(), frames.end(),
      [](const TrackingResult& f) { return f.status == TrackingStatus::initialized; }));
}

std::size_t SequenceResult::uncertain() const {
  return static_cast<std::size_t>(
      std::count_if(frames.begin(), frames.end(),
                    [](const TrackingResult& f) { return f.status == TrackingStatus::uncertain; }));
}

double SequenceResult::moving_fraction() const {
  double sum = 0;
  for (const TrackingResult& frame : frames) {
    sum += frame.moving_fraction;
  }
  return frames.empty() ? 0 : sum / static_cast<double>(frames.size());
}

std::map<TrackingReason, std::size_t> SequenceResult::reasons() const {
  std::map<TrackingReason, std::size_t> counts;
  for (const TrackingResult& frame : frames) {
    if (frame.reason != TrackingReason::none) {
      ++counts[frame.reason];
    }
  }
  return counts;
}

double SequenceResult::typical_depth_m() const {
  return depths_m.empty() ? 0 : upper_median(depths_m);
}

std::string note_on(const SequenceResult& result) {
  constexpr double kNearest = 0.35;  // m
  constexpr double kFarthest = 8;    // m
  std::string note;
  for (const auto& [reason, frames] : result.reasons()) {
    note +=
        concat(note.empty() ? "lost or uncertain frames: " : ", ", to_string(reason), " ", frames);
  }
  if (const std::size_t beginnings = result.beginnings(); beginnings > 1) {
    note += concat(note.empty() ? "" : "; ", "the map began anew ", beginnings - 1,
                   beginnings == 2 ? " time" : " times",
                   " at the first pose, since no frame was surely found on it");
  }
  const double depth = result.typical_depth_m();
  if (depth > 0 && (depth < kNearest || depth > kFarthest)) {
    note += concat(note.empty() ? "" : "; ", "the median depth is ", format_real(rounded_cm(depth)),
                   " m, which few depth cameras measure: is the camera's depth_units_per_m right?");
  }
  return note;
}

SequenceResult track_sequence(const SequenceReader& sequence, const TrackerOptions& options,
                              const SE3& T_world_first, const FrameObserver& observe,
                              const Progress& progress) {
  FrameStream stream(sequence);
  return track_frames(
      {.camera = sequence.camera(), .size = sequence.size(), .next = [&] { return stream.next(); }},
      options, T_world_first, observe, progress);
}

SequenceResult track_frames(const RgbdFrames& frames, const TrackerOptions& options,
                            const SE3& T_world_first, const FrameObserver& observe,
                            const Progress& progress) {
  RgbdOdometry odometry(frames.camera.pinhole, options.starting_from(frames.camera), T_world_first);
  SequenceResult result;
  while (const std::optional<RgbdFrame> frame = frames.next()) {
    result.frames.push_back(odometry.track(*frame));
    result.times.push_back(odometry.stage_times());
    if (const float depth = median_depth(frame->depth); has_depth(depth)) {
      result.depths_m.push_back(depth);
    }
    if (observe) {
      observe(*frame, odometry.current(), odometry.tracker(), result.frames.back(),
              odometry.stage_times());
    }
    progress(result.frames.size(), frames.size);
  }
  result.trajectory = odometry.trajectory();
  return result;
}

TimeSummary summarize(const std::vector<StageTimes>& times) {
  const std::vector<double> totals = stage(times, [](const StageTimes& t) { return t.total_ms(); });
  return {
      .median_ms = percentile(totals, 0.5),
      .p90_ms = percentile(totals, 0.9),
      .pyramid_ms = percentile(stage(times, [](const StageTimes& t) { return t.pyramid_ms; }), 0.5),
      .edges_ms = percentile(stage(times, [](const StageTimes& t) { return t.edges_ms; }), 0.5),
      .alignment_ms =
          percentile(stage(times, [](const StageTimes& t) { return t.alignment_ms; }), 0.5),
  };
}

std::string format_frame_log(const std::vector<TrackingResult>& frames) {
  std::string text = frame_log_header();
  for (const TrackingResult& frame : frames) {
    const AlignResult& alignment = frame.alignment;
    const bool aligned = frame.status != TrackingStatus::initialized;
    text += concat(format_timestamp(frame.timestamp), ",", to_string(frame.status), ",",
                   to_string(frame.reason), ",", frame.is_keyframe ? 1 : 0, ",",
                   aligned ? to_string(alignment.termination) : "none", ",", alignment.iterations,
                   ",", alignment.points);
    for (const double value :
         {alignment.visible_fraction, alignment.correlation, alignment.depth_agreement,
          frame.depth_deviation, alignment.cost, alignment.conditioning, alignment.noise_share,
          frame.readout.seconds}) {
      text += "," + format_real(value);
    }
    text += concat(",", to_string(frame.readout.axis));
    for (const double value : frame.vignette.coefficients) {
      text += "," + format_real(value);
    }
    text += "," + format_real(frame.moving_fraction);
    const bool has_reference = aligned && frame.status != TrackingStatus::lost;
    text += concat(",", has_reference ? format_timestamp(frame.reference_timestamp) : "",
                   covariance_values(alignment.covariance),
                   covariance_values(frame.absolute_covariance), "\n");
  }
  return text;
}

}  // namespace vo
