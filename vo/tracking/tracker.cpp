#include "vo/tracking/tracker.h"

#include <algorithm>
#include <utility>

#include "vo/core/error.h"
#include "vo/geometry/readout.h"
#include "vo/segmentation/depth_deviation.h"
#include "vo/tracking/pose_search.h"

namespace vo {
namespace {

// A pose where the camera was not expected is built upon, too, and must show more.
constexpr double kRecognisedCorrelation = 0.7;
constexpr double kRecognisedDepthAgreement = 0.8;

/// Share of the reference's edge points in view; with less the frame is lost.
constexpr double kMinVisibleFraction = 0.4;

/// Share of the view's tiles that move from which on it matters what hides what.
constexpr double kMuchMotion = 0.025;

/// Share of the loss's curvature by the read-out time that is left where the depths were found with
/// the same read-out time: with a wrong one they absorb nine tenths of what it bends.
constexpr double kMappedCurvatureShare = 0.1;

/// Returns a finder of points at a frame's own edges, whatever else chooses points while tracking.
EdgePointFinder own_point_finder(EdgePointOptions options) {
  options.source = EdgeSource::reference;
  return EdgePointFinder(options);
}

/// Returns whether the time between two frames says how fast the camera moved: a clock that stands
/// still, or stamps out of order, say nothing.
bool tells_velocity(double seconds) {
  constexpr double kMinSeconds = 1e-3;
  return seconds >= kMinSeconds;
}

}  // namespace

Tracker::Tracker(const TrackerOptions& options, SE3 T_world_first)
    : options_(options),
      map_(options.map),
      readout_(options.align.readout),
      own_point_finder_(own_point_finder(options.points)),
      reference_points_(std::make_shared<const EdgePoints>()),
      T_world_last_(std::move(T_world_first)) {
  options_.validate();
}

/// Returns the result of a frame that the map is to begin with, if it is fit for that.
TrackingResult Tracker::begun(const FramePyramid& current) {
  const bool fit = can_be_reference(current);
  last_timestamp_ = current.timestamp;
  return {.timestamp = current.timestamp,
          .T_world_camera = T_world_last_,
          .status = fit ? TrackingStatus::initialized : TrackingStatus::lost,
          .reason = fit ? TrackingReason::none : TrackingReason::too_few_points};
}

/// Returns whether a map on which no frame was surely found is given up with this frame, which is
/// lost: after 5 lost frames, then after 10, and from then on after 20. An image of a lens cap, of
/// noise or of another place begins a map, too.
bool Tracker::begins_anew(const FramePyramid& current) {
  constexpr int kLongestPatience = 20;
  const bool has_depth_image = !current.levels.front().depth.empty();
  if (!options_.lost.recover || was_sure_ || depth_is_mapped_ || ++lost_at_beginning_ < patience_ ||
      !has_depth_image || !can_be_reference(current)) {
    return false;
  }
  lost_at_beginning_ = 0;
  patience_ = std::min(2 * patience_, kLongestPatience);
  return true;
}

TrackingResult Tracker::track(const FramePyramid& current) {
  if (map_.empty()) {
    doubt_.see(current);
    return begun(current);
  }
  if (options_.symmetric) {
    find_current_points(current);
  }
  ++frames_since_keyframe_;
  doubt_.see(current);
  Attempt attempt = aligned_from(current, {Start::expected, starting_pose(current)});
  attempt = segmented(current, std::move(attempt));
  const double correlation = correlation_of(attempt.result.alignment, attempt.start);
  if (options_.lost.recover && is_doubtful(attempt.result.status, correlation)) {
    attempt = searched(current, std::move(attempt));
  }
  reference_points_ = attempt.references.points.front();
  attempt.result.moving_fraction = segmentation_.moving_fraction();
  if (attempt.result.status == TrackingStatus::tracked && options_.doubt) {
    judge_pose(current, attempt);
  }
  if (agrees_with_map(attempt.result)) {
    calibrate(current, attempt);
  }
  if (attempt.result.status != TrackingStatus::lost) {
    accept(current, attempt);
  } else {
    T_last_predicted_ = SE3();
    is_lost_ = true;
    segmentation_.reset();
    if (begins_anew(current)) {
      map_.clear();
      is_uncertain_ = false;
      absolute_covariance_.setZero();
      return begun(current);
    }
  }
  return attempt.result;
}

/// Reuses the memory of the last frame's points unless that frame became a keyframe.
void Tracker::find_current_points(const FramePyramid& current) {
  current_points_.reset();
  if (own_points_ == nullptr || own_points_.use_count() > 1) {
    own_points_ = std::make_shared<EdgePoints>();
  }
  own_point_finder_.find(current, current, *own_points_);
  if (is_segmenting()) {
    foresee_tiles(current);
  }
  use_points_outside(is_segmenting() ? unusable(moving_tiles(expected_)) : TileMask(), current);
}

SE3 Tracker::starting_pose(const FramePyramid& current) const {
  SE3 T_world_predicted = T_world_last_ * T_last_predicted_;
  return options_.motion_model == MotionModel::best
             ? best_guess(*map_.last(), current, {T_world_predicted, T_world_last_})
             : T_world_predicted;
}

References Tracker::references_for(const FramePyramid& current, const SE3& T_world_guess) const {
  References references{map_.references_for(T_world_guess), {}, {}, {}};
  const SE3 T_first_world = references.keyframes.front()->T_world_keyframe.inverse();
  for (const std::shared_ptr<const Keyframe>& keyframe : references.keyframes) {
    references.points.push_back(options_.points.source == EdgeSource::reference
                                    ? keyframe->points
                                    : std::make_shared<const EdgePoints>(edge_points(
                                          keyframe->pyramid, current, options_.points)));
    references.surfaces.push_back(keyframe->surface);
    references.views.push_back({*references.points.back(),
                                T_first_world * keyframe->T_world_keyframe,
                                options_.symmetric ? &keyframe->pyramid : nullptr,
                                keyframe->velocity.value_or(FrameVelocity()),
                                keyframe->surface.get(), keyframe->pyramid.vignette});
  }
  return references;
}

/// Returns the options of an alignment with the read-out that is known by now. Where something
/// moves, points that the depth image shows to be hidden have no part.
AlignOptions Tracker::align_options() const {
  AlignOptions options = options_.align;
  if (options_.shutter == ShutterModel::estimated) {
    options.readout = depth_is_mapped_ ? readout_.mapped() : readout_.readout();
  }
  if (segmentation_.moving_fraction() > kMuchMotion && options.max_depth_ratio == 0) {
    options.max_depth_ratio = kVisibleDepthRatio;
  }
  return options;
}

ReadoutMotion Tracker::readout_motion_at(const std::optional<FrameVelocity>& velocity) const {
  return velocity && readout().is_rolling() ? ReadoutMotion(velocity->twist, readout())
                                            : ReadoutMotion();
}

std::optional<Vector6d> Tracker::expected_velocity() const {
  const bool is_known = !is_lost_ && is_sure_ && mean_velocity_;
  return is_known ? std::optional(mean_velocity_->twist) : std::nullopt;
}

Tracker::Attempt Tracker::aligned_from(const FramePyramid& current, const Guess& guess) {
  References references = references_for(current, guess.T_world_camera);
  if (is_segmenting()) {
    const TileMask tiles = unusable(moving_tiles(expected_));
    if (share_of_view(tiles) > kMuchMotion) {
      references.leave_out(tiles, current, guess.T_world_camera);
    }
  }
  return aligned_with(current, guess, std::move(references), current_points_.get());
}

Tracker::Attempt Tracker::aligned_with(const FramePyramid& current, const Guess& guess,
                                       References references, const EdgePoints* points) {
  Attempt attempt{guess.start,
                  std::move(references),
                  {},
                  {.timestamp = current.timestamp, .T_world_camera = T_world_last_}};
  const Keyframe& first = *attempt.references.keyframes.front();
  const SE3& T_world_first = first.T_world_keyframe;
  const double seconds = current.timestamp - last_timestamp_;
  if (follows_motion(attempt) && tells_velocity(seconds)) {
    attempt.previous = {T_world_last_.inverse() * T_world_first, seconds, mean_velocity_};
  }
  AlignOptions options = align_options();
  if (is_segmenting() && options.max_depth_ratio == 0 && attempt.references.are_disturbed()) {
    options.max_depth_ratio = kVisibleDepthRatio;
  }
  TrackingResult& result = attempt.result;
  result.readout = options.readout;
  result.vignette = current.vignette;
  result.reference_timestamp = first.pyramid.timestamp;
  result.T_cur_ref_guess = guess.T_world_camera.inverse() * T_world_first;
  result.alignment = align(attempt.references.views, {current, points, attempt.previous},
                           result.T_cur_ref_guess, options, align_memory_);
  result.reason = judge(result.alignment, guess.start);
  if (result.reason == TrackingReason::none) {
    result.status = TrackingStatus::tracked;
    result.T_world_camera = T_world_first * result.alignment.T_cur_ref.inverse();
    result.absolute_covariance = compounded_covariance(
        result.alignment.T_cur_ref, result.alignment.covariance, first.absolute_covariance);
  }
  return attempt;
}

/// Returns whether the camera was aligned where its motion since the last tracked frame leads it.
bool Tracker::follows_motion(const Attempt& attempt) const {
  return !is_lost_ && attempt.start == Start::expected;
}

/// Takes in what an accepted frame says of the camera's shutter and vignette.
void Tracker::calibrate(const FramePyramid& current, const Attempt& attempt) {
  if (!attempt.previous) {
    return;
  }
  const AlignResult& aligned = attempt.result.alignment;
  if (options_.shutter == ShutterModel::estimated && attempt.references.velocities_known()) {
    readout_.update(aligned.loss_by_readout, attempt.result.readout,
                    depth_is_mapped_ ? kMappedCurvatureShare : 1);
    if (!depth_is_mapped_) {
      map_.forget_bent(align_options().readout);
    }
  }
  if (options_.vignette == VignetteModel::estimated) {
    vignette_.update(attempt.references.views, {current, current_points_.get(), attempt.previous},
                     aligned.T_cur_ref, align_options());
    map_.take_out(vignette_.vignette());
  }
}

/// Aligns from turned poses and from the keyframes that look most alike, too, and returns the most
/// credible attempt.
Tracker::Attempt Tracker::searched(const FramePyramid& current, Attempt first) {
  constexpr std::size_t kTurnsTried = 3;
  constexpr std::size_t kKeyframesTried = 3;
  std::vector<SE3> guesses =
      best_guesses(*map_.last(), current, turned_guesses(T_world_last_), kTurnsTried);
  for (const SE3& guess : similar_keyframes(map_, current, kKeyframesTried)) {
    guesses.push_back(guess);
  }
  Attempt best = std::move(first);
  for (const SE3& guess : guesses) {
    Attempt attempt = aligned_from(current, {Start::searched, guess});
    if (is_more_credible(attempt.result, best.result)) {
      best = std::move(attempt);
    }
  }
  return best;
}

/// Returns by how much the frame's depths differ from those of the first reference, leaving out
/// what moves; 0 where there are none.
double Tracker::depth_deviation_of(const FramePyramid& current, const Attempt& attempt) const {
  const std::size_t level = surface_level(current);
  const PyramidLevel& reference = attempt.references.keyframes.front()->pyramid.levels[level];
  if (reference.depth.empty() || current.levels[level].depth.empty()) {
    return 0;
  }
  return depth_deviation({reference, current.levels[level], attempt.result.alignment.T_cur_ref},
                         known_depth_noise(options_.points.depth_noise),
                         grown(segmentation_.moving()));
}

/// Marks a pose as uncertain where something speaks against it. After a repeated image it is not
/// known how the camera moves.
void Tracker::judge_pose(const FramePyramid& current, Attempt& attempt) {
  TrackingResult& result = attempt.result;
  const LocalMap::References& keyframes = attempt.references.keyframes;
  surfaces_.depth_deviation = depth_deviation_of(current, attempt);
  result.depth_deviation = surfaces_.depth_deviation;
  result.reason = doubt_.judge(result.alignment, surfaces_);
  const bool is_anchored = std::any_of(keyframes.begin(), keyframes.end(),
                                       [](const auto& each) { return !each->is_uncertain; });
  if (result.reason == TrackingReason::none && !is_anchored) {
    result.reason = TrackingReason::map_uncertain;
  }
  if (result.reason != TrackingReason::none) {
    result.status = TrackingStatus::uncertain;
  }
}

/// Returns the correlation that an alignment is judged by. Where poses are doubted, it is that of
/// the parts of the view that agree, if they are most of it; the place that a search found must be
/// recognised as a whole.
double Tracker::correlation_of(const AlignResult& alignment, Start start) const {
  constexpr double kMostOfView = 0.6;  // share of the points that may disagree
  const ViewAgreement& agreement = alignment.agreement;
  const bool by_parts = options_.doubt && !is_lost_ && start == Start::expected &&
                        agreement.disagreeing_fraction < kMostOfView;
  return by_parts ? agreement.agreeing_correlation : alignment.correlation;
}

TrackingReason Tracker::judge(const AlignResult& alignment, Start start) const {
  if (alignment.termination == Termination::too_few_points) {
    return TrackingReason::too_few_points;
  }
  if (alignment.termination == Termination::singular) {
    return TrackingReason::undetermined;
  }
  if (!(alignment.visible_fraction >= kMinVisibleFraction)) {
    return TrackingReason::out_of_view;
  }
  LostOptions least = options_.lost;
  if ((is_lost_ || start == Start::searched) && least.recover) {
    least.min_correlation = std::max(least.min_correlation, kRecognisedCorrelation);
    least.min_depth_agreement = std::max(least.min_depth_agreement, kRecognisedDepthAgreement);
  }
  if (!(correlation_of(alignment, start) >= least.min_correlation)) {
    return TrackingReason::images_disagree;
  }
  return alignment.depth_agreement >= least.min_depth_agreement ? TrackingReason::none
                                                                : TrackingReason::depths_disagree;
}

void Tracker::accept(const FramePyramid& current, const Attempt& attempt) {
  const SE3 T_last_cur = T_world_last_.inverse() * attempt.result.T_world_camera;
  const double seconds = current.timestamp - last_timestamp_;
  const bool follows = follows_motion(attempt);
  const std::optional<MeanVelocity> before = std::exchange(mean_velocity_, std::nullopt);
  velocity_.reset();
  if (follows && tells_velocity(seconds)) {
    mean_velocity_ = {T_last_cur.log() / seconds, seconds};
    velocity_ = velocity_at_end(*mean_velocity_, before);
    tell_first_velocity();
  }
  T_last_predicted_ =
      options_.motion_model != MotionModel::stationary && follows ? T_last_cur : SE3();
  T_world_last_ = attempt.result.T_world_camera;
  absolute_covariance_ = attempt.result.absolute_covariance;
  last_timestamp_ = current.timestamp;
  is_lost_ = attempt.result.reason == TrackingReason::image_repeated;
  is_sure_ = agrees_with_map(attempt.result);
  is_uncertain_ = attempt.result.status == TrackingStatus::uncertain &&
                  attempt.result.reason != TrackingReason::undetermined;
  was_sure_ = was_sure_ || is_sure_;
}

/// Gives a keyframe whose motion was not known the mean velocity until the frame after it, and as
/// its doubt and acceleration those that the second frame after it shows.
void Tracker::tell_first_velocity() {
  const std::optional<FrameVelocity>& known = map_.last()->velocity;
  if (frames_since_keyframe_ == 1 && !known) {
    map_.set_last_velocity({.twist = mean_velocity_->twist});
  } else if (frames_since_keyframe_ == 2 && known && known->acceleration.isZero(0)) {
    map_.set_last_velocity({known->twist, velocity_->doubt, velocity_->acceleration});
  }
}

}  // namespace vo
