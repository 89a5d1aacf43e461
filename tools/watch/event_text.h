#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"
#include "vo/geometry/trajectory.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/tracking/tracking_result.h"

namespace tools {

/// What is told of a frame.
struct WatchedFrame {
  std::size_t index = 0;
  vo::TrackingResult result;
  vo::StageTimes times;
  std::optional<vo::SE3> T_world_true;  ///< true pose, where it is known in the estimate's world
};

/// A stage of a run, which the page shows by itself: rendering, tracking.
struct WatchedStage {
  std::string name;        ///< what is done, `tracking`
  std::string title;       ///< with what, `rgbd_dataset_freiburg1_xyz`
  std::size_t frames = 0;  ///< number of frames or other steps
  std::optional<vo::PinholeCamera> camera;
  vo::Trajectory
      truth;            ///< true poses in the world of the estimate; empty where they are not known
  vo::Trajectory path;  ///< pose of each frame, where all are known beforehand; else empty
};

/// The data of events, as the report's web/src/live_data.ts declares them: JSON in one line.
std::string event_text(const nlohmann::ordered_json& json);
std::string stage_text(const WatchedStage& stage);
std::string path_text(const vo::Trajectory& path);
std::string progress_text(std::size_t done, std::size_t total);
std::string trial_text(const std::string& name, const std::string& verdict,
                       const std::string& text);
std::string problem_text(const std::string& text);
std::string end_text(const std::string& how, std::size_t frames_without_pictures);

/// Figures that the frame log has, too, are the same to the last digit.
std::string frame_text(const WatchedFrame& frame);

}  // namespace tools
