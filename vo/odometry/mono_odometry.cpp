#include "vo/odometry/mono_odometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/stopwatch.h"
#include "vo/odometry/lost_map.h"
#include "vo/odometry/start_maps.h"
#include "vo/tracking/tracker.h"

namespace vo {
namespace {

/// Least number of confident hypotheses that a map starts with.
constexpr std::size_t kMinConfident = 150;

/// Share of the hypotheses that are confident; with less, edges at guessed depths are tracked, too.
/// They say little of a translation, but all of a rotation, which shows edges that no parallax has
/// measured yet.
constexpr double kMinConfidentShare = 0.2;

/// Least correlation of a frame with edges at guessed depths, which explain a turn well or do not
/// explain the motion.
constexpr double kTurnCorrelation = 0.7;

/// Standard deviation of an unknown start's logarithmic scale from place to place: what its poses
/// are off bends its depths, which no later map contradicts.
constexpr double kUnknownStartScaleSigma = 0.04;

/// Standard deviation of the map's logarithmic scale up to which it is trusted: a factor of 1.28.
constexpr double kTrustedScaleSigma = 0.25;

}  // namespace

MonoOdometry::MonoOdometry(const PinholeCamera& camera, const MonoOptions& options,
                           const SE3& T_world_first)
    : camera_(tracked_camera(camera, options.tracker.lens)),
      options_(options),
      pyramid_builder_(camera_, options.tracker.pyramid),
      edge_finder_(options.tracker.edges),
      tracker_(std::make_unique<Tracker>(options.tracker, T_world_first)),
      map_(options.map),
      start_depth_(options.start_depth),
      T_world_start_(T_world_first),
      T_world_host_(T_world_first) {
  options_.validate();
}

MonoOdometry::MonoOdometry(MonoOdometry&& other) noexcept = default;
MonoOdometry& MonoOdometry::operator=(MonoOdometry&& other) noexcept = default;
MonoOdometry::~MonoOdometry() = default;

MonoResult MonoOdometry::track(const RgbdFrame& frame) {
  require(frame.image.size() == cv::Size(camera_.width, camera_.height),
          "mono: expected an image of the camera's ", camera_.width, "x", camera_.height, " px");
  Stopwatch timer;
  pyramid_builder_.build({frame.timestamp, frame.image, {}}, tracker_->vignette(), current_);
  stage_times_ = {.pyramid_ms = timer.lap_ms()};
  add_edges(current_, edge_finder_);
  stage_times_.edges_ms = timer.lap_ms();
  MonoResult result;
  result.tracking.timestamp = frame.timestamp;
  result.tracking.T_world_camera = T_world_host_;
  const bool depth_is_due = is_metric(options_.bootstrap) && (!frame.depth.empty() || is_first_);
  is_first_ = false;
  if (state_ == MonoState::initialising && depth_is_due) {
    start_from_depth(frame.depth, result);
  } else if (state_ == MonoState::initialising && is_guess(options_.bootstrap)) {
    start_from_guesses(result);
  } else if (state_ == MonoState::initialising) {
    initialise(result);
  } else {
    follow(result);
    if (state_ == MonoState::orienting || (state_ == MonoState::lost && initialiser_ != nullptr)) {
      look_for_start(result);
    }
  }
  report_state(result);
  return result;
}

std::optional<MonoResult> MonoOdometry::finish() {
  if (initialiser_ == nullptr) {
    return std::nullopt;
  }
  MonoResult result;
  result.tracking.timestamp = current_.timestamp;
  result.tracking.T_world_camera = T_world_host_;
  result.initialiser = initialiser_->finish();
  if (result.initialiser.verdict != InitialiserVerdict::solved ||
      !start_from(*std::exchange(initialiser_, nullptr), result)) {
    return std::nullopt;
  }
  report_state(result);
  return result;
}

void MonoOdometry::report_state(MonoResult& result) const {
  result.state = state_;
  result.hypotheses = map_.hypotheses().size();
  result.confident = map_.confident();
  result.scale = scale_watch_.scale();
}

void MonoOdometry::begin_tracking(const FramePyramid& host, Guesses guesses, MonoResult& result,
                                  std::optional<Readout> readout) {
  T_world_host_ = T_world_start_;
  guesses_ = guesses;
  TrackerOptions options = options_.tracker;
  options.align.readout = readout.value_or(tracker_->readout());
  if (guesses == Guesses::included && !is_guess(options_.bootstrap)) {
    options.lost.min_correlation = std::max(options.lost.min_correlation, kTurnCorrelation);
  }
  tracker_ = std::make_unique<Tracker>(options, T_world_host_);
  tracker_->set_keyframe(host, T_world_host_, tracked_points());
  state_ = state_in_map();
  lost_frames_ = 0;
  result.tracking.status = TrackingStatus::initialized;
  result.tracking.T_world_camera = T_world_host_;
  result.tracking.is_keyframe = true;
}

/// Returns the state while the camera is tracked: guesses that were asked for count as known.
MonoState MonoOdometry::state_in_map() const {
  if (is_guess(options_.bootstrap)) {
    return MonoState::tracking;
  }
  if (guesses_ == Guesses::included || map_.confident() < kMinConfident) {
    return MonoState::orienting;
  }
  return scale_watch_.scale().sigma > kTrustedScaleSigma ? MonoState::scale_uncertain
                                                         : MonoState::tracking;
}

bool MonoOdometry::follows_map() const {
  return is_in_map(state_) || state_ == MonoState::orienting;
}

void MonoOdometry::start_from_depth(const DepthImage& depth, MonoResult& result) {
  require(depth.size() == cv::Size(camera_.width, camera_.height),
          "mono: expected the first frame's depth image with the camera's ", camera_.width, "x",
          camera_.height, " px for the bootstrap, got ", depth.cols, "x", depth.rows, " px");
  map_ = measured_map(current_, depth, options_);
  if (map_.confident() < kMinConfident) {
    result.tracking.reason = TrackingReason::too_few_points;
    return;
  }
  begin_tracking(current_, Guesses::left_out, result);
  poses_.add(current_.timestamp, T_world_host_, state_);
}

/// Begins to track on a map of guessed depths at this frame. Returns whether it has edges enough.
bool MonoOdometry::guess_map(const FramePyramid& host, MonoResult& result) {
  DepthMap map = guessed_map(host, start_depth_, options_);
  if (map.hypotheses().size() < kMinConfident) {
    result.tracking.reason = TrackingReason::too_few_points;
    return false;
  }
  leave_map();
  map_ = std::move(map);
  begin_tracking(host, Guesses::included, result);
  return true;
}

void MonoOdometry::start_from_guesses(MonoResult& result) {
  if (guess_map(current_, result)) {
    poses_.add(current_.timestamp, T_world_host_, state_);
  }
}

void MonoOdometry::initialise(MonoResult& result) {
  result.tracking.reason = TrackingReason::undetermined;
  if (const auto solved = solved_start(result.initialiser)) {
    if (!start_from(*solved, result)) {
      result.tracking.reason = TrackingReason::too_few_points;
    }
  } else if (state_ == MonoState::initialising && initialiser_->is_exhausted()) {
    orient_from(*std::exchange(initialiser_, nullptr), result);
  }
}

/// Adds the frame to the start that is looked for, or begins to look for one. Returns the start
/// once it is solved, or null.
std::unique_ptr<MonoInitialiser> MonoOdometry::solved_start(InitialiserReport& report) {
  if (initialiser_ == nullptr || initialiser_->is_exhausted()) {
    const double scale = camera_.width / 640.0;
    const StartParallax parallax{scale * kMinStartParallaxPx, scale * options_.wanted_parallax_px};
    const bool is_given = options_.tracker.shutter == ShutterModel::given;
    initialiser_ = std::make_unique<MonoInitialiser>(
        current_, parallax, start_depth_,
        is_given ? std::optional(options_.tracker.align.readout) : std::nullopt);
    return nullptr;
  }
  report = initialiser_->add(current_);
  return report.verdict == InitialiserVerdict::solved ? std::exchange(initialiser_, nullptr)
                                                      : nullptr;
}

/// Tracks the rotation of frames that showed no start, by edges at guessed depths.
void MonoOdometry::orient_from(const MonoInitialiser& unsolved, MonoResult& result) {
  if (guess_map(unsolved.frames().front().pyramid, result)) {
    poses_.forget_since(unsolved.frames().front().pyramid.timestamp);
    track_again(unsolved, result);
  }
}

/// Looks for a start beside frames whose rotation alone is tracked, and beside those that are then
/// lost, for guessed depths do not follow a translation far. The start replaces the poses that its
/// frames were given.
void MonoOdometry::look_for_start(MonoResult& result) {
  if (initialiser_ == nullptr || initialiser_->is_exhausted()) {
    initialiser_.reset();
    if (state_ == MonoState::lost) {
      return;
    }
    place_next_map(result.tracking.T_world_camera);
  }
  if (const auto solved = solved_start(result.initialiser)) {
    start_from(*solved, result);
  }
}

/// Returns whether the start gives a map, in which its frames are then tracked.
bool MonoOdometry::start_from(const MonoInitialiser& solved, MonoResult& result) {
  DepthMap map = solved_map(solved, start_depth_, options_);
  if (map.confident() < kMinConfident) {
    return false;
  }
  leave_map();
  map_ = std::move(map);
  poses_.forget_since(solved.frames().front().pyramid.timestamp);
  begin_scale();
  begin_tracking(solved.frames().front().pyramid, Guesses::left_out, result, solved.readout());
  track_again(solved, result);
  return true;
}

/// Lets the scale of a new map be that of the run, or a guess where an earlier map had defined it.
void MonoOdometry::begin_scale() {
  if (poses_.has_pose_in_map()) {
    scale_watch_.lose_scale();
  } else {
    scale_watch_ = ScaleWatch(kUnknownStartScaleSigma);
  }
}

/// Keeps the map, which a new one is about to replace, to join the two when they meet. The first
/// map of a run stays: its scale defines that of the others.
void MonoOdometry::leave_map() {
  if (lost_map_ == nullptr && guesses_ == Guesses::left_out && poses_.has_pose_in_map()) {
    scale_watch_.add(
        {map_.host(), map_.hypotheses(), T_world_host_, tracker_->keyframe_readout_motion()});
    lost_map_ = std::make_unique<LostMap>(LostMap{*tracker_, scale_watch_});
  }
}

/// Tracks the frames of a start on the map that begins with the first of them.
void MonoOdometry::track_again(const MonoInitialiser& start, MonoResult& result) {
  if (lost_map_ != nullptr) {
    lost_map_->first_pose = poses_.size();
  }
  const std::vector<StartFrame>& frames = start.frames();
  poses_.add(frames.front().pyramid.timestamp, T_world_host_, state_);
  for (std::size_t i = 1; i < frames.size() && follows_map(); ++i) {
    current_ = frames[i].pyramid;
    follow(result);
  }
}

void MonoOdometry::follow(MonoResult& result) {
  Stopwatch timer;
  result.tracking = tracker_->track(current_);
  stage_times_.alignment_ms = timer.lap_ms();
  if (result.tracking.status == TrackingStatus::lost) {
    seek(result);
    return;
  }
  if (state_ == MonoState::reinitialising) {
    initialiser_.reset();
  }
  lost_frames_ = 0;
  update_map(result);
  state_ = state_in_map();
  stage_times_.mapping_ms = timer.lap_ms();
  poses_.add(current_.timestamp, result.tracking.T_world_camera, state_);
}

/// Waits for what the map shows to come back into view, and after some frames looks for a new map,
/// too, which begins where the camera was last seen, at the scale of the old one.
void MonoOdometry::seek(MonoResult& result) {
  if (++lost_frames_ < options_.max_lost_frames) {
    state_ = MonoState::lost;
    return;
  }
  if (state_ != MonoState::reinitialising) {
    state_ = MonoState::reinitialising;
    if (initialiser_ == nullptr) {
      place_next_map(poses_.trajectory().back().T_world_camera);
    }
  }
  initialise(result);
}

/// Lets the next map begin at this pose, at the scale of the map so far.
void MonoOdometry::place_next_map(const SE3& T_world_camera) {
  start_depth_ = 1 / median_inverse_depth(map_.hypotheses(), static_cast<float>(1 / start_depth_));
  T_world_start_ = T_world_camera;
}

FrameRelation MonoOdometry::relation_to_host(const TrackingResult& tracked) const {
  FrameRelation relation{tracked.T_world_camera.inverse() * T_world_host_,
                         tracked.alignment.covariance};
  relation.host_motion = tracker_->keyframe_readout_motion();
  relation.current_motion = tracker_->readout_motion();
  if (tracked.reference_timestamp == map_.host().timestamp) {
    relation.gain = tracked.alignment.gain;
    relation.offset = tracked.alignment.offset;
  }
  return relation;
}

void MonoOdometry::update_map(MonoResult& result) {
  map_.take_out(tracker_->vignette());
  FrameRelation relation = relation_to_host(result.tracking);
  result.observations = map_.observe(current_, relation);
  map_.regularise();
  if (is_guess(options_.bootstrap) && 2 * map_.confident() > map_.hypotheses().size()) {
    guesses_ = Guesses::left_out;
  }
  if (map_.needs_new_host(current_, relation.T_cur_host)) {
    watch_scale(relation, result);
    tracker_->update_keyframe(tracked_points());
    map_.propagate(current_, relation);
    map_.regularise();
    tracker_->set_keyframe(current_, result.tracking.T_world_camera, tracked_points());
    take_adjusted(*tracker_->map().last(), result);
    result.tracking.is_keyframe = true;
    join_lost_map(result);
  } else {
    tracker_->update_keyframe(tracked_points());
  }
}

/// Moves map and poses into the map that was lost, if the new keyframe is found in it.
void MonoOdometry::join_lost_map(MonoResult& result) {
  if (lost_map_ == nullptr) {
    return;
  }
  const std::optional<MapJoint> joint = lost_map_->joint_with(
      {current_, map_.hypotheses(), T_world_host_, tracker_->keyframe_readout_motion()});
  if (!joint) {
    return;
  }
  map_.rescale(joint->scale);
  T_world_host_ = joint->T_to_camera;
  *tracker_ = std::move(lost_map_->tracker);
  scale_watch_ = std::move(lost_map_->scale_watch);
  tracker_->set_keyframe(current_, T_world_host_, tracked_points());
  poses_.join_since(lost_map_->first_pose, *joint,
                    scale_watch_.scale().sigma <= kTrustedScaleSigma);
  lost_map_.reset();
  result.tracking.T_world_camera = T_world_host_;
  result.joins_maps = true;
}

/// Compares the map that is carried on with earlier ones. Where its scale is corrected, the motion
/// since its host is, too.
void MonoOdometry::watch_scale(FrameRelation& relation, MonoResult& result) {
  const ScaleEstimate& scale = scale_watch_.add(
      {map_.host(), map_.hypotheses(), T_world_host_, tracker_->keyframe_readout_motion()});
  if (scale.correction != 0) {
    const double factor = std::exp(scale.correction);
    const SE3& T = relation.T_cur_host;
    map_.rescale(factor);
    relation.T_cur_host = {T.rotation(), factor * T.translation()};
    result.tracking.T_world_camera = T_world_host_ * relation.T_cur_host.inverse();
  }
}

/// Takes the pose and the depths of the newest keyframe as the tracker's window has adjusted them.
void MonoOdometry::take_adjusted(const Keyframe& keyframe, MonoResult& result) {
  T_world_host_ = keyframe.T_world_keyframe;
  result.tracking.T_world_camera = keyframe.T_world_keyframe;
  if (options_.tracker.window.adjust == WindowAdjustment::depth) {
    map_.correct(keyframe.points->levels.front());
  }
}

std::shared_ptr<const EdgePoints> MonoOdometry::tracked_points() const {
  const bool few = static_cast<double>(map_.confident()) <
                   kMinConfidentShare * static_cast<double>(map_.hypotheses().size());
  return std::make_shared<const EdgePoints>(
      map_.points(options_.tracker.points, few ? Guesses::included : guesses_));
}

}  // namespace vo
