#include "tools/report/report_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/pictures/base64.h"
#include "tools/report/frame_errors.h"
#include "tools/report/pictures_json.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/version.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxCloudPoints = 15000;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numbers(const std::vector<std::optional<double>>& values) {
  Json json = Json::array();
  for (const std::optional<double>& value : values) {
    json.push_back(value ? rounded(*value) : Json(nullptr));
  }
  return json;
}

Json poses_json(const FramePoses& poses) {
  Json json = Json::array();
  for (const std::optional<vo::SE3>& T_world_camera : poses) {
    json.push_back(nullptr);
    if (T_world_camera) {
      const Eigen::Vector3d& t = T_world_camera->translation();
      const Eigen::Vector4d q = T_world_camera->rotation().coeffs();
      json.back() = {rounded(t.x()), rounded(t.y()), rounded(t.z()), rounded(q.x()),
                     rounded(q.y()), rounded(q.z()), rounded(q.w())};
    }
  }
  return json;
}

/// Returns an array with `select` applied to each element.
template <typename T, typename Select>
Json column(const std::vector<T>& elements, Select select) {
  Json json = Json::array();
  for (const T& element : elements) {
    json.push_back(select(element));
  }
  return json;
}

Json metrics_json(const std::vector<ReportedMetric>& metrics) {
  return column(metrics, [](const ReportedMetric& metric) {
    const Bound bound = metric.bound.value_or(Bound{});
    return Json{{"name", metric.name},
                {"value", number(metric.value)},
                {"min", number(bound.min)},
                {"max", number(bound.max)},
                {"holds", metric.bound ? Json(metric.holds) : Json(nullptr)}};
  });
}

Json options_json(const std::vector<ReportedOption>& options) {
  return column(options, [](const ReportedOption& option) {
    return Json{{"key", option.key},
                {"value", option.value},
                {"preset", option.preset},
                {"help", option.help}};
  });
}

/// Returns the times of the tracker's frames; without any, those of the true or estimated poses.
std::vector<double> timestamps_of(const ScenarioReport& report) {
  std::vector<double> timestamps;
  for (const vo::TrackingResult& frame : report.frames) {
    timestamps.push_back(frame.timestamp);
  }
  if (timestamps.empty()) {
    for (const vo::StampedPose& pose : report.truth.empty() ? report.estimate : report.truth) {
      timestamps.push_back(pose.timestamp);
    }
  }
  return timestamps;
}

Json status_json(const std::vector<vo::TrackingResult>& frames) {
  return column(frames,
                [](const vo::TrackingResult& frame) { return vo::to_string(frame.status); });
}

Json tracking_json(const std::vector<vo::TrackingResult>& frames) {
  using Frame = vo::TrackingResult;
  return {{"reason", column(frames, [](const Frame& f) { return vo::to_string(f.reason); })},
          {"keyframe", column(frames, [](const Frame& f) { return f.is_keyframe; })},
          {"termination",
           column(frames, [](const Frame& f) { return vo::to_string(f.alignment.termination); })},
          {"iterations", column(frames, [](const Frame& f) { return f.alignment.iterations; })},
          {"points", column(frames, [](const Frame& f) { return f.alignment.points; })},
          {"visible_fraction",
           column(frames, [](const Frame& f) { return rounded(f.alignment.visible_fraction); })},
          {"correlation",
           column(frames, [](const Frame& f) { return rounded(f.alignment.correlation); })},
          {"cost", column(frames, [](const Frame& f) { return rounded(f.alignment.cost); })},
          {"moving_fraction",
           column(frames, [](const Frame& f) { return rounded(f.moving_fraction); })}};
}

/// Returns the aligned poses of the frames; all are empty with fewer than three matched poses.
FramePoses aligned_poses(const ScenarioReport& report, const std::vector<double>& timestamps) {
  const std::optional<vo::Trajectory> aligned =
      vo::align_trajectory(report.truth, report.estimate, {.alignment = report.alignment});
  return aligned ? poses_of_frames(*aligned, timestamps) : FramePoses(timestamps.size());
}

Json frames_json(const ScenarioReport& report, const std::vector<double>& timestamps) {
  const FramePoses truth = interpolated_poses(report.truth, timestamps);
  const FramePoses estimate = poses_of_frames(report.estimate, timestamps);
  const FramePoses aligned = aligned_poses(report, timestamps);
  const FrameErrors errors = frame_errors(truth, estimate, aligned);
  Json json = {{"timestamp", column(timestamps, rounded)},
               {"truth", poses_json(truth)},
               {"estimate", poses_json(estimate)},
               {"aligned", poses_json(aligned)},
               {"position_m", numbers(errors.position_m)},
               {"rotation_deg", numbers(errors.rotation_deg)},
               {"step_translation_m", numbers(errors.step_translation_m)},
               {"step_rotation_deg", numbers(errors.step_rotation_deg)}};
  if (!report.frames.empty()) {
    json["status"] = status_json(report.frames);
  }
  if (!report.frames.empty() && report.tracker.empty()) {
    json["tracking"] = tracking_json(report.frames);
  }
  return json;
}

Json gallery_json(const std::vector<FramePictures>& gallery,
                  const std::vector<double>& timestamps) {
  Json json = Json::array();
  for (const FramePictures& pictures : gallery) {
    const auto found = std::find(timestamps.begin(), timestamps.end(), pictures.timestamp);
    vo::require(found != timestamps.end(), "report: a picture at ", pictures.timestamp,
                " s, expected the time of a frame");
    json.push_back(pictures_json(pictures, static_cast<std::size_t>(found - timestamps.begin())));
  }
  return json;
}

Json cloud_json(const PointCloud& cloud) {
  return {
      {"count", cloud.count},
      {"origin", column(std::vector<double>(cloud.origin.begin(), cloud.origin.end()), rounded)},
      {"step", cloud.step},
      {"positions", base64(cloud.positions)},
      {"colours", base64(cloud.colours)}};
}

Json times_json(const std::vector<vo::StageTimes>& times) {
  using Times = vo::StageTimes;
  return {{"pyramid_ms", column(times, [](const Times& t) { return rounded(t.pyramid_ms); })},
          {"edges_ms", column(times, [](const Times& t) { return rounded(t.edges_ms); })},
          {"alignment_ms", column(times, [](const Times& t) { return rounded(t.alignment_ms); })}};
}

/// Returns what is known of the run besides its verdict.
Json run_json(const ScenarioReport& report) {
  const std::vector<double> timestamps = timestamps_of(report);
  Json json = {{"options", options_json(report.options)},
               {"frames", frames_json(report, timestamps)},
               {"stride", report.gallery.stride()},
               {"pictures", gallery_json(report.gallery.pictures(), timestamps)}};
  if (report.camera) {
    json["camera"] = camera_json(*report.camera);
  }
  const PointCloud cloud = quantised(
      merge_views(report.gallery.views(), report.truth.empty() ? report.estimate : report.truth,
                  kMaxCloudPoints));
  if (cloud.count > 0) {
    json["cloud"] = cloud_json(cloud);
  }
  if (!report.times.empty()) {
    json["times"] = times_json(report.times);
  }
  return json;
}

Json scenario_json(const ScenarioReport& report) {
  Json json = {{"name", report.name},
               {"why", report.why},
               {"folder", report.repeat.folder},
               {"command", report.repeat.command},
               {"passed", report.passed()},
               {"alignment", vo::to_string(report.alignment)},
               {"metrics", metrics_json(report.metrics)},
               {"notes", report.notes}};
  if (!report.tracker.empty()) {
    json["tracker"] = report.tracker;
  }
  if (!report.problem.empty()) {
    json["problem"] = report.problem;
  }
  const Json run = report.data ? *report.data : run_json(report);
  for (const auto& [key, value] : run.items()) {
    if (!json.contains(key) && key != "problem") {
      json[key] = value;
    }
  }
  return json;
}

ReportedMetric metric_of_data(const Json& json) {
  const auto number_or = [&](const char* key, double otherwise) {
    return json.at(key).is_null() ? otherwise : json.at(key).get<double>();
  };
  ReportedMetric metric{.name = json.at("name").get<std::string>(),
                        .value = number_or("value", std::numeric_limits<double>::quiet_NaN()),
                        .bound = {},
                        .holds = true};
  if (!json.at("holds").is_null()) {
    metric.bound = Bound{number_or("min", Bound{}.min), number_or("max", Bound{}.max)};
    metric.holds = json.at("holds").get<bool>();
  }
  return metric;
}

vo::Trajectory poses_of_data(const Json& timestamps, const Json& poses) {
  vo::Trajectory trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i].is_null()) {
      const auto p = poses[i].get<std::array<double, 7>>();
      trajectory.push_back(
          {timestamps.at(i).get<double>(),
           vo::SE3(Eigen::Quaterniond(p[6], p[3], p[4], p[5]), {p[0], p[1], p[2]})});
    }
  }
  return trajectory;
}

}  // namespace

Json report_data(const std::vector<ScenarioReport>& scenarios) {
  return {{"schema", "edvo-report"},
          {"version", kReportDataVersion},
          {"generator", vo::concat("edvo ", vo::version())},
          {"scenarios", column(scenarios, scenario_json)}};
}

ScenarioReport report_of_data(const Json& entry) {
  ScenarioReport report;
  report.name = entry.at("name").get<std::string>();
  report.why = entry.at("why").get<std::string>();
  report.repeat = {.folder = entry.at("folder").get<std::string>(),
                   .command = entry.at("command").get<std::string>()};
  report.tracker = entry.value("tracker", std::string());
  report.problem = entry.value("problem", std::string());
  for (const Json& metric : entry.at("metrics")) {
    report.metrics.push_back(metric_of_data(metric));
  }
  report.notes = entry.at("notes").get<std::vector<std::string>>();
  report.alignment =
      vo::parse_enum<vo::TrajectoryAlignment>(entry.at("alignment").get<std::string>());
  const Json& frames = entry.at("frames");
  report.truth = poses_of_data(frames.at("timestamp"), frames.at("truth"));
  report.estimate = poses_of_data(frames.at("timestamp"), frames.at("estimate"));
  report.data = std::make_shared<Json>(entry);
  return report;
}

}  // namespace tools
