#include "tools/commands/track_outcome.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include <nlohmann/json.hpp>

#include "tools/cli/exit_code.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/json/document.h"
#include "tools/point_cloud/point_cloud.h"
#include "tools/report/report.h"
#include "vo/core/error.h"
#include "vo/files/output.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/sequence_odometry/time_log.h"

namespace tools {
namespace {

/// Returns what is known of the scale at each keyframe of a monocular run.
nlohmann::ordered_json scales_json(const vo::MonoSequenceResult& mono) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const vo::MonoResult& frame : mono.frames) {
    if (frame.tracking.is_keyframe) {
      json.push_back({{"timestamp", frame.tracking.timestamp},
                      {"scale_drift", frame.scale.drift},
                      {"scale_sigma", frame.scale.sigma},
                      {"joins_maps", frame.joins_maps}});
    }
  }
  return json;
}

/// Returns how many frames are lost or uncertain for each reason.
nlohmann::ordered_json reasons_json(const vo::SequenceResult& result) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [reason, frames] : result.reasons()) {
    json[std::string(vo::to_string(reason))] = frames;
  }
  return json;
}

/// Returns how sure the last pose is, relative to the first frame; null without a pose.
nlohmann::ordered_json last_pose_json(const vo::SequenceResult& result) {
  const auto last = std::find_if(result.frames.rbegin(), result.frames.rend(), [](const auto& f) {
    return f.status != vo::TrackingStatus::lost;
  });
  if (last == result.frames.rend()) {
    return nullptr;
  }
  const vo::Vector6d variance = last->absolute_covariance.diagonal();
  constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
  return {{"timestamp", last->timestamp},
          {"sigma_m", std::sqrt(variance.head<3>().sum())},
          {"sigma_deg", kDegreesPerRadian * std::sqrt(variance.tail<3>().sum())}};
}

nlohmann::ordered_json summary(const TrackArguments& arguments, const Tracked& tracked) {
  nlohmann::ordered_json json = {{"sequence", arguments.sequence}, {"estimate", arguments.out}};
  if (tracked.mono != nullptr) {
    json["mode"] = arguments.mode;
  }
  json["frames"] = tracked.result.frames.size();
  json["tracked_fraction"] = tracked.result.tracked_fraction();
  json["uncertain"] = tracked.result.uncertain();
  json["reasons"] = reasons_json(tracked.result);
  json["keyframes"] = tracked.result.keyframes();
  if (tracked.camera) {
    json["camera"] = {{"device", tracked.camera->device}, {"dropped", tracked.camera->dropped}};
  }
  json["ms_per_frame"] = time_json(vo::summarize(tracked.result.times));
  if (tracked.mono != nullptr) {
    json["mapping_ms"] = tracked.mono->mapping_ms();
    json["oriented_poses"] = tracked.mono->oriented_poses;
    json["scale_uncertain_poses"] = tracked.mono->scale_uncertain_poses;
    json["keyframe_scales"] = scales_json(*tracked.mono);
  } else {
    json["preset"] = arguments.preset;
    json["moving_fraction"] = tracked.result.moving_fraction();
    json["last_pose"] = last_pose_json(tracked.result);
    json["typical_depth_m"] = tracked.result.typical_depth_m();
  }
  json["note"] = tracked.note;
  json["sequence_notes"] = tracked.sequence_notes;
  json["options"] = fields_json(tracked.options);
  return json;
}

/// Returns how many frames have a pose, and how many of those are uncertain, for people.
std::string describe_status(const vo::SequenceResult& result, const Colours& colours) {
  const std::string counts =
      vo::concat(result.trajectory.size(), " of ", result.frames.size(), " frames tracked");
  const bool is_lost = result.trajectory.size() < result.frames.size();
  const std::string uncertain =
      result.uncertain() > 0 ? vo::concat(result.uncertain(), " of them uncertain") : "";
  return (is_lost ? colours.paint(Tone::bad, counts) : counts) + ", " +
         colours.paint(Tone::caution, uncertain) + (uncertain.empty() ? "" : ", ");
}

}  // namespace

std::string Tracked::text() const {
  const std::string counts =
      vo::concat(result.trajectory.size(), " of ", result.frames.size(), " frames tracked");
  return camera ? vo::concat(counts, ", ", camera->dropped, " dropped") : counts;
}

void write_tracked(const TrackArguments& arguments, const Tracked& tracked, KeyframeCloud& cloud) {
  vo::write_file(arguments.out, vo::format_trajectory(tracked.result.trajectory),
                 arguments.common.output_policy());
  write_config(arguments, tracked.options);
  if (!arguments.frame_log.empty()) {
    vo::write_file(arguments.frame_log, tracked.log, arguments.common.output_policy());
  }
  if (!arguments.time_log.empty()) {
    vo::write_file(arguments.time_log, vo::format_time_log(tracked.result),
                   arguments.common.output_policy());
  }
  if (!arguments.save_map.empty()) {
    vo::write_file(arguments.save_map, encode(cloud.finish(), cloud_format_of(arguments.save_map)),
                   arguments.common.output_policy());
  }
}

int print_tracked(const TrackArguments& arguments, const Tracked& tracked, const Session& session) {
  const auto [out, colours] =
      speech_beside(session, {vo::is_stream(arguments.out) ? vo::kStdoutPath : arguments.out,
                              arguments.frame_log, arguments.time_log});
  const vo::SequenceResult& result = tracked.result;
  if (arguments.common.json) {
    out << json_text(json_document({"track"}, summary(arguments, tracked)));
  } else {
    const vo::TimeSummary times = vo::summarize(result.times);
    out << arguments.out << ": " << describe_status(result, colours)
        << (tracked.camera ? vo::concat(tracked.camera->dropped, " dropped, ") : "")
        << result.keyframes() << " keyframes, " << times.median_ms
        << " ms per frame (median; pyramid " << times.pyramid_ms << ", edges " << times.edges_ms
        << ", alignment " << times.alignment_ms
        << (tracked.mono != nullptr ? vo::concat(", mapping ", tracked.mono->mapping_ms()) : "")
        << ")\n"
        << (result.trajectory.empty() || tracked.note.empty()
                ? ""
                : colours.paint(Tone::caution, tracked.note) + "\n");
    out << note_lines(tracked.sequence_notes, colours);
  }
  if (result.trajectory.empty() && !tracked.note.empty()) {
    std::cerr << error_line(session.err, tracked.note);
  }
  return tracked.is_complete() ? exit_code::kOk : exit_code::kTrackingLost;
}

}  // namespace tools
