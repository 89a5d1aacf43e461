#include "tools/watch/finished_track.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <opencv2/core.hpp>

#include "tools/pictures/webp.h"
#include "tools/report/pictures_json.h"
#include "tools/watch/log_table.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/folder.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPanelEnding = ".png";

/// The poses of a trajectory by their stamps as logs write them.
using PosesByStamp = std::map<std::string, vo::SE3>;

/// Returns the covariance of the position that a row has, all else 0.
vo::Matrix6d covariance_of(const LogTable& table, std::size_t row) {
  constexpr std::array kAxes{"tx", "ty", "tz"};
  vo::Matrix6d covariance = vo::Matrix6d::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const std::string name =
          vo::concat("absolute_covariance_", kAxes.at(static_cast<unsigned>(i)), "_",
                     kAxes.at(static_cast<unsigned>(j)));
      covariance(i, j) = covariance(j, i) = table.number_or(row, name, 0);
    }
  }
  return covariance;
}

vo::TrackingResult result_of(const LogTable& table, std::size_t row) {
  vo::TrackingResult result;
  result.timestamp = table.number(row, "timestamp");
  result.status = table.choice<vo::TrackingStatus>(row, "status");
  result.reason = table.choice<vo::TrackingReason>(row, "reason");
  result.is_keyframe = table.number(row, "keyframe") != 0;
  const bool is_aligned = result.status != vo::TrackingStatus::initialized;
  vo::AlignResult& alignment = result.alignment;
  if (is_aligned && table.has("termination")) {
    alignment.termination = table.choice<vo::Termination>(row, "termination");
  }
  alignment.iterations = static_cast<int>(table.number_or(row, "iterations", 0));
  alignment.points = static_cast<std::size_t>(table.number_or(row, "points", 0));
  alignment.visible_fraction = table.number_or(row, "visible_fraction", 0);
  alignment.correlation = table.number_or(row, "correlation", 0);
  alignment.cost = table.number_or(row, "cost", 0);
  result.moving_fraction = table.number_or(row, "moving_fraction", 0);
  result.absolute_covariance = covariance_of(table, row);
  return result;
}

/// Returns the frames of a log, with the poses of the trajectory.
std::vector<WatchedFrame> frames_of_log(const fs::path& log, const PosesByStamp& poses) {
  const LogTable table(log);
  std::vector<WatchedFrame> frames;
  std::size_t found = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    WatchedFrame frame{
        .index = row, .result = result_of(table, row), .times = {}, .T_world_true = {}};
    const auto pose = poses.find(vo::format_timestamp(frame.result.timestamp));
    if (pose != poses.end()) {
      frame.result.T_world_camera = pose->second;
      ++found;
    } else {
      frame.result.status = vo::TrackingStatus::lost;
    }
    frames.push_back(frame);
  }
  vo::require(found == poses.size(), log.string(), ": is the log of another track: ", found,
              " of its frames are among the ", poses.size(), " poses of the trajectory");
  return frames;
}

std::vector<WatchedFrame> frames_of_poses(const vo::Trajectory& trajectory) {
  std::vector<WatchedFrame> frames;
  for (const vo::StampedPose& pose : trajectory) {
    WatchedFrame frame{.index = frames.size(), .result = {}, .times = {}, .T_world_true = {}};
    frame.result.timestamp = pose.timestamp;
    frame.result.T_world_camera = pose.T_world_camera;
    frame.result.status = vo::TrackingStatus::tracked;
    frames.push_back(frame);
  }
  return frames;
}

void add_times(const fs::path& log, std::vector<WatchedFrame>& frames) {
  const LogTable table(log);
  vo::require(table.rows() == frames.size(), log.string(), ": has the times of ", table.rows(),
              " frames, expected ", frames.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    frames[row].times = {.pyramid_ms = table.number(row, "pyramid_ms"),
                         .edges_ms = table.number(row, "edges_ms"),
                         .alignment_ms = table.number(row, "alignment_ms"),
                         .mapping_ms = table.number(row, "mapping_ms")};
  }
}

/// Returns the number that a panel's name is, such as 000012.png; nothing for another name.
std::optional<std::size_t> frame_of_panel(const std::string& name) {
  if (!name.ends_with(kPanelEnding)) {
    return {};
  }
  const std::string digits = name.substr(0, name.size() - kPanelEnding.size());
  const bool is_number = !digits.empty() && digits.size() < 10 &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? std::optional<std::size_t>(std::stoul(digits)) : std::nullopt;
}

std::vector<FramePanel> panels_in(const fs::path& folder, std::size_t frames) {
  std::vector<FramePanel> panels;
  for (const vo::FolderEntry& entry : vo::entries_of(folder)) {
    if (const std::optional<std::size_t> frame = frame_of_panel(entry.name)) {
      vo::require(*frame < frames, (folder / entry.name).string(), ": is of frame ", *frame,
                  ", the track has ", frames, " frames");
      panels.push_back({*frame, folder / entry.name});
    }
  }
  return panels;
}

/// Returns the pictures that a panel consists of but depth, whose range of values only its picture
/// says: `draw_panel` has three in each of two rows.
FramePictures pictures_of(const fs::path& file) {
  constexpr int kColumns = 3;
  constexpr int kRows = 2;
  constexpr double kQuality = 80;  // of 100
  const cv::Mat image = vo::read_png(file);
  vo::require(image.type() == CV_8UC3 && image.cols % kColumns == 0 && image.rows % kRows == 0,
              file.string(), ": is no panel of `edvo track --debug-images`");
  const cv::Size size(image.cols / kColumns, image.rows / kRows);
  const auto webp = [&](int column, int row) {
    return encode_webp(image(cv::Rect({column * size.width, row * size.height}, size)), kQuality);
  };
  FramePictures pictures{.timestamp = 0,
                         .size = size,
                         .colour = webp(0, 0),
                         .edges = webp(1, 0),
                         .residual_before = webp(0, 1),
                         .residual_after = webp(1, 1)};
  return pictures;
}

}  // namespace

TrackFiles with_files_beside(TrackFiles files) {
  const auto beside = [&](const char* ending) {
    fs::path path = files.trajectory;
    path.replace_extension();
    path += ending;
    return path;
  };
  if (files.frame_log.empty() && fs::is_regular_file(beside(".csv"))) {
    files.frame_log = beside(".csv");
  }
  if (files.time_log.empty() && fs::is_regular_file(beside("_times.csv"))) {
    files.time_log = beside("_times.csv");
  }
  if (files.panels.empty() && fs::is_directory(beside("_panels"))) {
    files.panels = beside("_panels");
  }
  return files;
}

std::size_t FinishedTrack::poses() const {
  return static_cast<std::size_t>(std::count_if(
      frames.begin(), frames.end(),
      [](const WatchedFrame& frame) { return frame.result.status != vo::TrackingStatus::lost; }));
}

FinishedTrack read_finished_track(const TrackFiles& files) {
  const vo::Trajectory trajectory = vo::read_trajectory(files.trajectory);
  FinishedTrack track{.title = files.trajectory.filename().string(), .frames = {}, .panels = {}};
  if (files.frame_log.empty()) {
    track.frames = frames_of_poses(trajectory);
  } else {
    PosesByStamp poses;
    for (const vo::StampedPose& pose : trajectory) {
      poses[vo::format_timestamp(pose.timestamp)] = pose.T_world_camera;
    }
    track.frames = frames_of_log(files.frame_log, poses);
  }
  if (!files.time_log.empty()) {
    add_times(files.time_log, track.frames);
  }
  if (!files.panels.empty()) {
    track.panels = panels_in(files.panels, track.frames.size());
  }
  return track;
}

void tell(const FinishedTrack& track, EventFeed& feed) {
  constexpr std::size_t kMostPictures = 96;  // which the page keeps
  feed.keep("stage", stage_text({.name = "tracked",
                                 .title = track.title,
                                 .frames = track.frames.size(),
                                 .camera = {},
                                 .truth = {},
                                 .path = {}}));
  for (const WatchedFrame& frame : track.frames) {
    feed.keep("frame", frame_text(frame));
  }
  const std::size_t pictures = std::min(track.panels.size(), kMostPictures);
  for (std::size_t i = 0; i < pictures; ++i) {
    const FramePanel& panel = track.panels[i * track.panels.size() / pictures];
    feed.keep("pictures", event_text(pictures_json(pictures_of(panel.file), panel.frame)));
  }
  feed.end("end",
           end_text(vo::concat(track.poses(), " of ", track.frames.size(), " frames have a pose"),
                    track.frames.size() - pictures));
}

}  // namespace tools
