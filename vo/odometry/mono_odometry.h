#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "vo/bootstrap/mono_initialiser.h"
#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"
#include "vo/mapping/depth_map.h"
#include "vo/odometry/mono_options.h"
#include "vo/odometry/mono_state.h"
#include "vo/odometry/pose_history.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/scale/scale_watch.h"
#include "vo/tracking/local_map.h"

namespace vo {

struct LostMap;

/// The result of one frame.
struct MonoResult {
  TrackingResult tracking;
  MonoState state = MonoState::initialising;  ///< state after the frame
  InitialiserReport initialiser;              ///< parallax measurement while initialising
  std::size_t hypotheses = 0;
  std::size_t confident = 0;
  ObservationCounts observations;
  ScaleEstimate scale;      ///< of the map, as known since its last host
  bool joins_maps = false;  ///< whether the map and the one that was lost became one
};

/// Monocular edge-direct odometry: the RGB-D odometry's tracker on an inverse-depth map that is
/// observed with each frame and propagated from host to host.
class MonoOdometry {
 public:
  explicit MonoOdometry(const PinholeCamera& camera, const MonoOptions& options = mono_options(),
                        const SE3& T_world_first = {});
  MonoOdometry(MonoOdometry&& other) noexcept;
  MonoOdometry& operator=(MonoOdometry&& other) noexcept;
  ~MonoOdometry();

  /// Tracks a frame. Its depth is read only until a bootstrap that asks for it has succeeded; later
  /// frames need none. Throws Error when an image has another size than the camera, or the first
  /// frame lacks the depth that the bootstrap needs.
  MonoResult track(const RgbdFrame& frame);

  /// Ends the sequence. If an unknown start still waits for more parallax than it needs, it is made
  /// with what there is, its frames are tracked, and the result that `track` should have returned
  /// for the last frame is returned; else nothing is returned and nothing changes.
  std::optional<MonoResult> finish();

  const Trajectory& trajectory() const { return poses_.trajectory(); }  ///< frames not lost
  const PoseHistory& poses() const { return poses_; }  ///< the same with their states
  const StageTimes& stage_times() const { return stage_times_; }
  const DepthMap& map() const { return map_; }
  const SE3& T_world_host() const { return T_world_host_; }
  const FramePyramid& current() const { return current_; }
  const Tracker& tracker() const { return *tracker_; }

 private:
  void start_from_depth(const DepthImage& depth, MonoResult& result);
  bool guess_map(const FramePyramid& host, MonoResult& result);
  void start_from_guesses(MonoResult& result);
  void initialise(MonoResult& result);
  void orient_from(const MonoInitialiser& unsolved, MonoResult& result);
  void look_for_start(MonoResult& result);
  std::unique_ptr<MonoInitialiser> solved_start(InitialiserReport& report);
  bool start_from(const MonoInitialiser& solved, MonoResult& result);
  void track_again(const MonoInitialiser& start, MonoResult& result);
  void begin_tracking(const FramePyramid& host, Guesses guesses, MonoResult& result,
                      std::optional<Readout> readout = {});
  void follow(MonoResult& result);
  void seek(MonoResult& result);
  void place_next_map(const SE3& T_world_camera);
  FrameRelation relation_to_host(const TrackingResult& tracked) const;
  void update_map(MonoResult& result);
  void take_adjusted(const Keyframe& keyframe, MonoResult& result);
  MonoState state_in_map() const;
  void leave_map();
  void join_lost_map(MonoResult& result);
  void begin_scale();
  bool follows_map() const;  ///< whether the last frame has a pose
  void watch_scale(FrameRelation& relation, MonoResult& result);
  void report_state(MonoResult& result) const;
  std::shared_ptr<const EdgePoints> tracked_points() const;

  PinholeCamera camera_;
  MonoOptions options_;
  PyramidBuilder pyramid_builder_;
  EdgeFinder edge_finder_;
  std::unique_ptr<Tracker> tracker_;
  std::unique_ptr<MonoInitialiser> initialiser_;  ///< null unless a start is looked for
  DepthMap map_;
  ScaleWatch scale_watch_;
  double start_depth_ = 1;  ///< m, median depth of an unknown start
  SE3 T_world_start_;       ///< pose of the first frame of the next map
  SE3 T_world_host_;
  FramePyramid current_;
  PoseHistory poses_;
  std::unique_ptr<LostMap> lost_map_;  ///< the first map that the camera has left, or null
  StageTimes stage_times_;
  Guesses guesses_ = Guesses::left_out;  ///< whether guessed depths are tracked, too
  MonoState state_ = MonoState::initialising;
  int lost_frames_ = 0;
  bool is_first_ = true;
};

}  // namespace vo
