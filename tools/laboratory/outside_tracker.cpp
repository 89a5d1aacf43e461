#include "tools/laboratory/outside_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "tools/processes/child_process.h"
#include "tools/processes/scratch_folder.h"
#include "vo/core/error.h"
#include "vo/dataset/trajectory_file.h"
#include "vo/files/input.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr int kLost = 5;                     // exit code of a tracker that was lost
constexpr double kMaxTimeDifference = 0.02;  // s, between a pose and its frame

std::string replaced(std::string text, const std::string& name, const fs::path& path) {
  const std::string value = shell_quoted(fs::absolute(path).string());
  for (std::size_t at = text.find(name); at != std::string::npos;
       at = text.find(name, at + value.size())) {
    text.replace(at, name.size(), value);
  }
  return text;
}

/// Returns `; it last said: ` with the program's last line of output, or nothing.
std::string last_words(const fs::path& printed) {
  std::string text = fs::exists(printed) ? vo::read_file(printed) : "";
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) {
    text.pop_back();
  }
  constexpr std::size_t kMaxLength = 200;
  const std::string line = text.substr(text.find_last_of('\n') + 1);
  return line.empty() ? "" : "; it last said: " + line.substr(0, kMaxLength);
}

OutsideRun failed_run(ProblemKind kind, const std::string& sentence) {
  return {.tracking = {}, .problem = sentence, .kind = kind};
}

/// Returns what is wrong with how the program ended; nothing where that is as it should be.
std::optional<OutsideRun> bad_end(const ChildEnd& end, const OutsideTracker& tracker,
                                  const fs::path& printed) {
  constexpr int kShellSignal = 128;  // a shell's exit code for signal n is 128 + n
  const int signal = end.exit_code > kShellSignal ? end.exit_code - kShellSignal : end.signal;
  const std::string said = last_words(printed);
  if (end.timed_out) {
    return failed_run(
        ProblemKind::timeout,
        vo::concat("the tracker was ended after ", tracker.time_limit, " s, its time limit", said));
  }
  if (signal != 0) {
    return failed_run(ProblemKind::crash,
                      vo::concat("the tracker crashed (signal ", signal, ")", said));
  }
  if (end.exit_code != 0 && end.exit_code != kLost) {
    return failed_run(ProblemKind::tracker, vo::concat("the tracker ended with exit code ",
                                                       end.exit_code, ", expected 0", said));
  }
  return {};
}

/// Returns whether there is no output file, or one of comments alone: all frames were lost.
bool has_no_pose(const fs::path& output) {
  std::istringstream lines(fs::is_regular_file(output) ? vo::read_file(output) : "");
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() != '#') {
      return false;
    }
  }
  return true;
}

vo::SequenceResult all_lost(const vo::SequenceReader& sequence) {
  vo::SequenceResult result;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    result.frames.push_back({.timestamp = sequence.timestamp(i)});
  }
  return result;
}

/// Reads the trajectory. Errors do not name the temporary file, which the user does not know.
vo::Trajectory read_output(const fs::path& output, const fs::path& printed) {
  vo::require(fs::exists(output), "the tracker wrote no trajectory to {output}",
              last_words(printed));
  vo::require(fs::is_regular_file(output), "the tracker made {output} no file");
  const std::string bytes = vo::read_file(output);
  vo::require(!bytes.empty(), "the tracker wrote an empty trajectory");
  vo::require(bytes.back() == '\n', "the tracker's trajectory ends within a line");
  try {
    return vo::read_trajectory(output);
  } catch (const vo::Error& error) {
    std::string text = error.what();
    const std::size_t at = text.find(output.string());
    if (at != std::string::npos) {
      text.replace(at, output.string().size(), "the tracker's trajectory");
    }
    vo::fail(text);
  }
}

const vo::StampedPose* find_pose(const vo::Trajectory& trajectory, double timestamp) {
  const auto nearest = std::min_element(trajectory.begin(), trajectory.end(),
                                        [&](const vo::StampedPose& a, const vo::StampedPose& b) {
                                          return std::abs(a.timestamp - timestamp) <
                                                 std::abs(b.timestamp - timestamp);
                                        });
  const bool is_near =
      nearest != trajectory.end() && std::abs(nearest->timestamp - timestamp) <= kMaxTimeDifference;
  return is_near ? &*nearest : nullptr;
}

/// Moves the estimate so that its first pose equals the ground truth at that time.
void move_to_truth(vo::Trajectory& estimate, const vo::Trajectory& truth) {
  const vo::StampedPose* first = find_pose(truth, estimate.front().timestamp);
  vo::require(first != nullptr, "the tracker's trajectory begins at ",
              vo::format_timestamp(estimate.front().timestamp),
              " s, expected the time of a frame of the sequence");
  const vo::SE3 T_world_own = first->T_world_camera * estimate.front().T_world_camera.inverse();
  for (vo::StampedPose& pose : estimate) {
    pose.T_world_camera = T_world_own * pose.T_world_camera;
  }
}

/// Returns the estimate's poses at the times of the frames, moved to the truth's first pose.
vo::SequenceResult poses_of_frames(const vo::Trajectory& estimate,
                                   const vo::SequenceReader& sequence) {
  vo::require(!estimate.empty(), "the tracker's trajectory has no pose");
  vo::SequenceResult result;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    vo::TrackingResult frame{.timestamp = sequence.timestamp(i)};
    if (const vo::StampedPose* pose = find_pose(estimate, frame.timestamp)) {
      frame.status = vo::TrackingStatus::tracked;
      result.trajectory.push_back({frame.timestamp, pose->T_world_camera});
    }
    result.frames.push_back(frame);
  }
  vo::require(!result.trajectory.empty(),
              "the tracker's trajectory has no pose at the time of a "
              "frame, expected stamps of rgb.txt");
  move_to_truth(result.trajectory, sequence.ground_truth());
  for (std::size_t i = 0, pose = 0; i < result.frames.size(); ++i) {
    if (result.frames[i].status == vo::TrackingStatus::tracked) {
      result.frames[i].T_world_camera = result.trajectory[pose++].T_world_camera;
    }
  }
  return result;
}

}  // namespace

void OutsideTracker::validate() const {
  for (const char* name : {"{sequence}", "{output}"}) {
    vo::require(command.find(name) != std::string::npos, "--tracker ", command, ": expected ", name,
                " in it");
  }
  vo::require(time_limit > 0, "--time-limit: expected above 0, got ", time_limit);
}

OutsideRun track_outside(const OutsideTracker& tracker, const fs::path& folder,
                         const vo::SequenceReader& sequence, const WaitObserver& waiting) {
  const ScratchFolder scratch;
  const fs::path output = scratch.path() / "trajectory.txt";
  const fs::path printed = scratch.path() / "printed.txt";
  std::string command = replaced(tracker.command, "{sequence}", folder);
  command = replaced(command, "{camera}", folder / "camera.toml");
  command = replaced(command, "{output}", output);
  const ChildEnd end = run_child(command, printed, tracker.time_limit, waiting);
  if (const std::optional<OutsideRun> bad = bad_end(end, tracker, printed)) {
    return *bad;
  }
  if (end.exit_code == kLost && has_no_pose(output)) {
    return {.tracking = all_lost(sequence), .problem = ""};
  }
  try {
    return {.tracking = poses_of_frames(read_output(output, printed), sequence), .problem = ""};
  } catch (const vo::Error& error) {
    return failed_run(ProblemKind::tracker, error.what());
  }
}

std::map<std::string, Bound> outside_bounds(const std::map<std::string, Bound>& expect) {
  std::map<std::string, Bound> known = expect;
  for (const char* metric :
       {"keyframes", "nees_median", "nees_p90", "nees_absolute_median", "nees_absolute_p90",
        "repeat_difference_m", "ate_percent", "scale_error_percent", "scale_drift_percent",
        "depth_error_percent", "depth_outliers_percent", "depth_nees", "depth_density_fraction"}) {
    known.erase(metric);
  }
  return known;
}

}  // namespace tools
