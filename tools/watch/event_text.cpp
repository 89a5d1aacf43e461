#include "tools/watch/event_text.h"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "tools/report/pictures_json.h"
#include "tools/watch/watch_page.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// Returns the upper triangle, row by row, of the covariance of the position.
Json position_covariance(const vo::Matrix6d& covariance) {
  Json json = Json::array();
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      json.push_back(finite(covariance(i, j)));
    }
  }
  return json;
}

Json pose_json(const vo::SE3& T_world_camera) {
  const Eigen::Vector3d& t = T_world_camera.translation();
  const Eigen::Vector4d q = T_world_camera.rotation().coeffs();
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

}  // namespace

std::string event_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string stage_text(const WatchedStage& stage) {
  return event_text({{"schema", "edvo-live"},
                     {"version", kLiveVersion},
                     {"stage", stage.name},
                     {"title", stage.title},
                     {"frames", stage.frames},
                     {"camera", stage.camera ? camera_json(*stage.camera) : Json(nullptr)}});
}

std::string path_text(const vo::Trajectory& path) {
  Json timestamps = Json::array();
  Json poses = Json::array();
  for (const vo::StampedPose& pose : path) {
    timestamps.push_back(pose.timestamp);
    poses.push_back(pose_json(pose.T_world_camera));
  }
  return event_text({{"timestamps", std::move(timestamps)}, {"poses", std::move(poses)}});
}

std::string progress_text(std::size_t done, std::size_t total) {
  return event_text({{"done", done}, {"total", total}});
}

std::string trial_text(const std::string& name, const std::string& verdict,
                       const std::string& text) {
  return event_text({{"name", name}, {"verdict", verdict}, {"text", text}});
}

std::string problem_text(const std::string& text) {
  return event_text({{"text", text}});
}

std::string end_text(const std::string& how, std::size_t frames_without_pictures) {
  return event_text({{"how", how}, {"frames_without_pictures", frames_without_pictures}});
}

std::string frame_text(const WatchedFrame& frame) {
  const vo::TrackingResult& result = frame.result;
  const vo::AlignResult& alignment = result.alignment;
  const bool is_aligned = result.status != vo::TrackingStatus::initialized;
  const bool is_lost = result.status == vo::TrackingStatus::lost;
  return event_text({{"frame", frame.index},
                     {"timestamp", result.timestamp},
                     {"pose", is_lost ? Json(nullptr) : pose_json(result.T_world_camera)},
                     {"truth", frame.T_world_true ? pose_json(*frame.T_world_true) : Json(nullptr)},
                     {"status", vo::to_string(result.status)},
                     {"reason", vo::to_string(result.reason)},
                     {"keyframe", result.is_keyframe},
                     {"termination", is_aligned ? vo::to_string(alignment.termination) : "none"},
                     {"iterations", alignment.iterations},
                     {"points", alignment.points},
                     {"visible_fraction", finite(alignment.visible_fraction)},
                     {"correlation", finite(alignment.correlation)},
                     {"cost", finite(alignment.cost)},
                     {"moving_fraction", finite(result.moving_fraction)},
                     {"position_covariance", position_covariance(result.absolute_covariance)},
                     {"times_ms",
                      {frame.times.pyramid_ms, frame.times.edges_ms, frame.times.alignment_ms,
                       frame.times.mapping_ms}}});
}

}  // namespace tools
