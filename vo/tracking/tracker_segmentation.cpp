#include <algorithm>
#include <utility>

#include "vo/segmentation/tile_surfaces.h"
#include "vo/tracking/image_motion.h"
#include "vo/tracking/tracker.h"

/// This file holds how the tracker tells the world from what moves in it.
namespace vo {
namespace {

/// Share of the view's tiles that move from which on all references are asked.
constexpr double kStirring = 0.04;

/// Share of the aligned points in moving tiles that is worth another alignment without them.
constexpr double kFew = 0.03;

}  // namespace

bool Tracker::is_segmenting() const {
  return options_.doubt && options_.symmetric;
}

/// Says of the tiles of the tracked frame what is known before it is aligned.
void Tracker::foresee_tiles(const FramePyramid& current) {
  tile_depths_ = tile_depths(current);
  expected_ = segmentation_.expected(tile_depths_);
  covered_ = covered_tiles(current, tile_depths_);
  surfaces_.covered_fraction = share_of_view(covered_);
  surfaces_.changed_motion = false;
}

/// Returns the tiles that are not aligned: what moves, and what is covered, with its border.
TileMask Tracker::unusable(const TileMask& moving) const {
  constexpr double kCover = 0.1;  // share of the view, less is something black
  return surfaces_.covered_fraction > kCover ? moving | grown(covered_) : moving;
}

/// Uses the tracked frame's points that lie outside these tiles. Points that a keyframe does not
/// hold are overwritten.
void Tracker::use_points_outside(const TileMask& tiles, const FramePyramid& current) {
  current_points_ = own_points_;
  if (tiles.none()) {
    return;
  }
  if (fewer_points_ == nullptr || fewer_points_.use_count() > 1) {
    fewer_points_ = std::make_shared<EdgePoints>();
  }
  *fewer_points_ = *own_points_;
  leave_out(tiles, current, *fewer_points_);
  current_points_ = fewer_points_;
}

/// Returns what the tiles show if the frame's pose is that of an alignment, in which the motion
/// since the previous frame was known or not.
Tracker::Explanation Tracker::explained(const FramePyramid& current, const References& references,
                                        const std::optional<PreviousFrame>& previous,
                                        const AlignResult& aligned) {
  const ComparedReferences compared = segmentation_.moving_fraction() < kStirring
                                          ? ComparedReferences::outer
                                          : ComparedReferences::all;
  const StaticEvidence evidence(references.views, {current, own_points_.get(), previous}, aligned,
                                align_options(), compared);
  Explanation explanation{.aligned = aligned, .evidence = evidence};
  label(log_odds_after(expected_, evidence.of_current()), explanation);
  return explanation;
}

/// Labels the tiles by the log-odds that they are static.
void Tracker::label(const TileEvidence& log_odds, Explanation& explanation) const {
  explanation.log_odds = log_odds;
  explanation.moving = moving_tiles(log_odds);
  explanation.areas = surface_areas(log_odds, tile_depths_, ~TileMask());
}

/// Aligns what lies in these tiles alone, from the last pose. How the camera moved until then is
/// not known if it did not move as all points together seem to.
AlignResult Tracker::aligned_in(const TileMask& tiles, const FramePyramid& current,
                                const Attempt& attempt) {
  const TileMask others = ~tiles;
  EdgePoints points = *own_points_;
  leave_out(others, current, points);
  if (points.levels.front().size() < static_cast<std::size_t>(options_.align.min_points)) {
    return {};
  }
  References references = attempt.references;
  references.leave_out(others, current, attempt.T_world_camera());
  return aligned_with(current, {Start::searched, T_world_last_}, std::move(references), &points)
      .result.alignment;
}

/// Returns what speaks for the motion of an explanation.
MotionSupport Tracker::supported(const FramePyramid& current, const Attempt& attempt,
                                 const Explanation& explanation) const {
  MotionSupport support{intensity_support(explanation.evidence.of_current(), tile_depths_)};
  const std::shared_ptr<const SurfacePoints>& surface = attempt.references.surfaces.front();
  if (surface != nullptr) {
    support.by_surfaces = surface_support(
        {*surface, current.levels[surface_level(current)], explanation.aligned.T_cur_ref},
        known_depth_noise(options_.points.depth_noise));
  }
  return support;
}

/// Returns whether much moves if the explanation is right, or starts to move at once.
bool Tracker::is_contested(const Explanation& explanation) const {
  constexpr double kSurprising = 0.05;
  constexpr double kCompeting = 0.4;
  return explanation.areas.moving_ratio() >= kCompeting ||
         share_of_view(explanation.moving & ~moving_tiles(expected_)) >= kSurprising;
}

/// Returns the tiles whose motions may be the camera's rather than that of all points: where that
/// leaves some of the view unexplained, the far ones, because things that move are mostly before
/// the world; where it is contested, also those that it leaves unexplained.
Tracker::Rivals Tracker::rivals_of(const Explanation& explanation) const {
  constexpr double kMoving = 0.05;
  constexpr double kDisagreeing = 0.05;
  Rivals rivals{.are_contested = is_contested(explanation), .tiles = {}};
  if (rivals.are_contested) {
    rivals.tiles.push_back(grown(explanation.moving));
  }
  if (rivals.are_contested || share_of_view(explanation.moving) > kMoving ||
      explanation.aligned.agreement.disagreeing_fraction > kDisagreeing) {
    rivals.tiles.push_back(~grown(~far_tiles(tile_depths_)));
  }
  return rivals;
}

/// Returns whether a frame's points are displaced by more than a pixel between two poses that may
/// be the frame's, `T_a_b` from one to the other.
bool Tracker::differs(const SE3& T_a_b, const FramePyramid& current) const {
  return image_motion(*own_points_, current, T_a_b).flow_px > 1;
}

/// Returns the explanation of the frame by the motion of the attempt, or by a rival that is clearly
/// better: that is clearly better supported or, where motions are contested, explains a clearly
/// larger area of surfaces as static; support does not outweigh a smaller one there. Things that
/// move are smaller than the world. The attempt's alignment becomes that of the motion.
Tracker::Explanation Tracker::best_explanation(const FramePyramid& current, Attempt& attempt) {
  constexpr double kClearlyMore = 1.1;
  Explanation best =
      explained(current, attempt.references, attempt.previous, attempt.result.alignment);
  const TileEvidence before = best.evidence.of_current();
  const Rivals rivals = rivals_of(best);
  for (const TileMask& tiles : rivals.tiles) {
    const AlignResult other = aligned_in(tiles, current, attempt);
    if (!other.usable() || !differs(best.aligned.T_cur_ref * other.T_cur_ref.inverse(), current)) {
      continue;
    }
    Explanation rival = explained(current, attempt.references, std::nullopt, other);
    const double larger = rival.areas.of_static / best.areas.of_static;
    const bool is_better =
        (rivals.are_contested && larger > kClearlyMore) ||
        ((!rivals.are_contested || larger > 1) &&
         is_clearly_better(supported(current, attempt, rival), supported(current, attempt, best)));
    if (is_better) {
      best = std::move(rival);
      best.is_another_motion = true;
      best.tiles = tiles;
    }
  }
  if (best.is_another_motion) {
    attempt.result.alignment = best.aligned;
    label(log_odds_after_change(expected_, before, best.evidence.of_current()), best);
  }
  return best;
}

/// Leaves out of keyframes what has moved since they were taken; the evidence is of a frame that
/// was compared with them, in this order. Where most of a view seems to have moved, it is the depth
/// or the pose that is wrong.
void Tracker::forget_moved(const LocalMap::References& keyframes, const StaticEvidence& evidence) {
  constexpr double kNone = 0.01;
  constexpr double kMost = 0.5;
  for (std::size_t r = 0; r < keyframes.size(); ++r) {
    const Keyframe& keyframe = *keyframes[r];
    const TileMask moved = moving_tiles(evidence.of_reference(r));
    if (share_of_view(moved) < kMost &&
        share_in(moved, keyframe.pyramid, *keyframe.points) > kNone) {
      map_.leave_out(keyframe, moved);
    }
  }
}

/// Aligns what does not move, from the attempt's pose.
Tracker::Attempt Tracker::aligned_without(const TileMask& moving, const FramePyramid& current,
                                          const Attempt& attempt) {
  const TileMask tiles = unusable(moving);
  use_points_outside(tiles, current);
  const SE3 T_world_camera = attempt.T_world_camera();
  References references = references_for(current, T_world_camera);
  references.leave_out(tiles, current, T_world_camera);
  return aligned_with(current, {attempt.start, T_world_camera}, std::move(references),
                      current_points_.get());
}

/// Tells the world from what moves in it, and returns the attempt without the latter. Nothing is
/// learnt from a frame that is lost.
Tracker::Attempt Tracker::segmented(const FramePyramid& current, Attempt attempt) {
  if (!is_segmenting() || !attempt.result.alignment.usable()) {
    return attempt;
  }
  const LocalMap::References compared = attempt.references.keyframes;
  const Explanation best = best_explanation(current, attempt);
  surfaces_.changed_motion = best.is_another_motion;
  if (best.is_another_motion) {
    attempt.start = Start::searched;
  }
  if (best.is_another_motion || share_in(best.moving, current, *current_points_) >= kFew) {
    attempt = aligned_without(best.moving | ~best.tiles, current, attempt);
  }
  if (best.areas.moving_ratio() >= 1 && attempt.result.status != TrackingStatus::lost) {
    attempt.result.status = TrackingStatus::lost;
    attempt.result.reason = TrackingReason::two_motions;
    attempt.result.T_world_camera = T_world_last_;
    attempt.result.absolute_covariance.setZero();
  }
  if (attempt.result.status == TrackingStatus::lost) {
    use_points_outside(unusable(moving_tiles(expected_)), current);
    return attempt;
  }
  segmentation_.update(tile_depths_, best.log_odds);
  surfaces_.edged =
      surface_areas(best.log_odds, tile_depths_, tiles_with_points(current, *own_points_));
  forget_moved(compared, best.evidence);
  return attempt;
}

}  // namespace vo
