#include "tools/outside_tracker/outside_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>

#include "tools/outside_tracker/plausibility.h"
#include "tools/outside_tracker/staged_sequence.h"
#include "tools/outside_tracker/tracker_command.h"
#include "tools/processes/child_process.h"
#include "tools/processes/scratch_folder.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/files/output.h"
#include "vo/files/result_files.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr int kLost = 5;                     // exit code of a tracker that was lost
constexpr double kMaxTimeDifference = 0.02;  // s, between a pose and its frame

/// Returns `; it last said: ` with the last line of a program's output, or nothing.
std::string last_words(std::string printed) {
  while (!printed.empty() && std::isspace(static_cast<unsigned char>(printed.back())) != 0) {
    printed.pop_back();
  }
  constexpr std::size_t kMaxLength = 200;
  const std::string line = printed.substr(printed.find_last_of('\n') + 1);
  return line.empty() ? "" : "; it last said: " + line.substr(0, kMaxLength);
}

ChildLimits child_limits(const TrackerLimits& limits) {
  constexpr double kMegabyte = 1e6;  // bytes
  return {.time = limits.time_limit,
          .memory = kMegabyte * limits.memory_limit,
          .processes = static_cast<double>(limits.process_limit),
          .output = kMegabyte * limits.output_limit,
          .file = kMegabyte * limits.file_limit};
}

OutsideRun failed_run(ProblemKind kind, const std::string& sentence) {
  return {.tracking = {}, .problem = sentence, .kind = kind};
}

/// Returns why the program was ended.
std::string limit_sentence(ExceededLimit exceeded, const TrackerLimits& limits) {
  switch (exceeded) {
    case ExceededLimit::time:
      return vo::concat("the tracker was ended after ", limits.time_limit, " s, its time limit");
    case ExceededLimit::memory:
      return vo::concat("the tracker was ended for holding more than ", limits.memory_limit,
                        " MB of memory (--memory-limit)");
    case ExceededLimit::processes:
      return vo::concat("the tracker was ended for running more than ", limits.process_limit,
                        " processes (--process-limit)");
    case ExceededLimit::output:
      return vo::concat("the tracker was ended for printing more than ", limits.output_limit,
                        " MB (--output-limit)");
    case ExceededLimit::none:
      break;
  }
  return "";
}

/// Returns the signal that ended the program, or the one that a shell ended it for; 0 for none.
int signal_of(const ChildEnd& end) {
  constexpr int kShellSignal = 128;  // a shell's exit code for signal n is 128 + n
  constexpr int kLastSignal = 64;
  const int signal = end.exit_code - kShellSignal;
  return signal > 0 && signal <= kLastSignal ? signal : end.signal;
}

/// Returns what is wrong with how the program ended; nothing where that is as it should be.
std::optional<OutsideRun> bad_end(const ChildEnd& end, const TrackerLimits& limits) {
  const std::string said = last_words(end.tail);
  if (end.exceeded != ExceededLimit::none) {
    const bool is_timeout = end.exceeded == ExceededLimit::time;
    return failed_run(is_timeout ? ProblemKind::timeout : ProblemKind::tracker,
                      limit_sentence(end.exceeded, limits) + said);
  }
  const int signal = signal_of(end);
  if (signal == SIGXFSZ) {
    return failed_run(ProblemKind::tracker,
                      vo::concat("the tracker wrote a file of more than ", limits.file_limit,
                                 " MB (--file-limit)", said));
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
vo::Trajectory read_output(const fs::path& output, const std::string& printed) {
  constexpr std::uintmax_t kMaxBytes = 100'000'000;
  const fs::file_status status = fs::symlink_status(output);
  vo::require(fs::exists(status), "the tracker wrote no trajectory to {output} or $EDVO_OUTPUT",
              last_words(printed));
  vo::require(fs::is_regular_file(status), "the tracker made {output} no file");
  vo::require(fs::file_size(output) <= kMaxBytes, "the tracker's trajectory has more than ",
              kMaxBytes, " bytes");
  const std::string bytes = vo::read_file(output);
  vo::require(!bytes.empty(), "the tracker wrote an empty trajectory");
  vo::require(bytes.back() == '\n', "the tracker's trajectory ends within a line");
  try {
    vo::TrajectoryFile file =
        vo::read_trajectory_file(output, {.format = vo::TrajectoryFormat::tum});
    vo::require(file.notes.empty(), file.notes.empty() ? "" : file.notes.front());
    return std::move(file.trajectory);
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

/// Returns the alignment that leaves free what images alone do not tell.
vo::TrajectoryAlignment alignment_of(vo::SequenceContent content) {
  return content == vo::SequenceContent::colour ? vo::TrajectoryAlignment::sim3
                                                : vo::TrajectoryAlignment::se3;
}

}  // namespace

void TrackerLimits::validate() const {
  vo::require(time_limit > 0, "--time-limit: expected above 0, got ", time_limit);
  vo::require(memory_limit > 0, "--memory-limit: expected above 0, got ", memory_limit);
  vo::require(process_limit > 0, "--process-limit: expected above 0, got ", process_limit);
  vo::require(output_limit > 0, "--output-limit: expected above 0, got ", output_limit);
  vo::require(file_limit > 0, "--file-limit: expected above 0, got ", file_limit);
}

void OutsideTracker::validate() const {
  validate_tracker_command(command);
  limits.validate();
}

OutsideRun track_outside(const OutsideTracker& tracker, const fs::path& folder,
                         vo::SequenceContent content, const vo::SequenceReader& sequence,
                         const vo::WaitObserver& waiting) {
  const ScratchFolder scratch;
  const fs::path staged = scratch.path() / "sequence";
  stage_sequence(folder, content, staged, waiting);
  const TrackerPlaces places{.sequence = staged,
                             .camera = staged / "camera.toml",
                             .output = scratch.path() / "work" / "trajectory.txt",
                             .scratch = scratch.path() / "work",
                             .withheld = tracker.withheld};
  vo::make_folder(places.scratch);
  const ChildCommand command = tracker_command(tracker.command, places);
  ChildEnd end;
  try {
    end = run_child(command, child_limits(tracker.limits), waiting);
  } catch (const vo::Error& error) {
    waiting();
    return failed_run(ProblemKind::tracker, vo::concat("the tracker ", error.what()));
  }
  if (const std::optional<OutsideRun> bad = bad_end(end, tracker.limits)) {
    return *bad;
  }
  if (end.exit_code == kLost && has_no_pose(places.output)) {
    return {.tracking = all_lost(sequence), .problem = ""};
  }
  try {
    OutsideRun run{.tracking = poses_of_frames(read_output(places.output, end.tail), sequence),
                   .problem = ""};
    run.problem =
        implausibility(sequence.ground_truth(), run.tracking.trajectory, alignment_of(content),
                       {.truth = position_unit(folder / "groundtruth.txt"),
                        .estimate = position_unit(places.output)});
    run.kind = ProblemKind::implausible;
    return run;
  } catch (const vo::Error& error) {
    return failed_run(ProblemKind::tracker, error.what());
  }
}

std::map<std::string, Bound> outside_bounds(const std::map<std::string, Bound>& expect) {
  std::map<std::string, Bound> known = expect;
  for (const char* metric :
       {"keyframes", "nees_median", "nees_p90", "nees_absolute_median", "nees_absolute_p90",
        "sure_error_max_m", "repeat_difference_m", "ate_percent", "scale_error_percent",
        "scale_drift_percent", "depth_error_percent", "depth_outliers_percent", "depth_nees",
        "depth_density_fraction"}) {
    known.erase(metric);
  }
  return known;
}

}  // namespace tools
