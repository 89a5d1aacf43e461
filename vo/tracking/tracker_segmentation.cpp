#include <algorithm>
#include <utility>

#include "vo/segmentation/tile_surfaces.h"
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

Tracker::Explanation Tracker::explained(const FramePyramid& current, const Attempt& attempt,
                                        const AlignResult& aligned) {
  const ComparedReferences compared = segmentation_.moving_fraction() < kStirring
                                          ? ComparedReferences::outer
                                          : ComparedReferences::all;
  const StaticEvidence evidence(attempt.references.views,
                                {current, own_points_.get(), attempt.previous}, aligned,
                                align_options(), compared);
  const TileEvidence log_odds = log_odds_after(expected_, evidence.of_current());
  return {evidence, log_odds, moving_tiles(log_odds),
          surface_areas(log_odds, tile_depths_, ~TileMask())};
}

/// Aligns what lies in these tiles alone, from the last pose.
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
  return aligned_with(current, {attempt.start, T_world_last_}, std::move(references), &points)
      .result.alignment;
}

/// Returns the motion that explains the larger area of surfaces as static: that of the attempt, of
/// what it leaves unexplained, or of what is far. Things that move are smaller than the world, and
/// mostly before it.
Tracker::Explanation Tracker::best_explanation(const FramePyramid& current, Attempt& attempt) {
  constexpr double kSurprising = 0.05;
  constexpr double kCompeting = 0.4;
  constexpr double kClearlyMore = 1.1;
  Explanation best = explained(current, attempt, attempt.result.alignment);
  if (share_of_view(best.moving & ~moving_tiles(expected_)) < kSurprising &&
      best.areas.moving_ratio() < kCompeting) {
    return best;
  }
  for (const TileMask& tiles : {grown(best.moving), ~grown(~far_tiles(tile_depths_))}) {
    const AlignResult other = aligned_in(tiles, current, attempt);
    if (!other.usable()) {
      continue;
    }
    Explanation explanation = explained(current, attempt, other);
    if (explanation.areas.of_static > kClearlyMore * best.areas.of_static) {
      best = std::move(explanation);
      best.is_another_motion = true;
      attempt.result.alignment = other;
    }
  }
  return best;
}

/// Leaves out of the references what has moved since they were taken. Where most of a view seems to
/// have moved, it is the depth or the pose that is wrong.
void Tracker::forget_moved(const References& references, const StaticEvidence& evidence) {
  constexpr double kNone = 0.01;
  constexpr double kMost = 0.5;
  for (std::size_t r = 0; r < references.keyframes.size(); ++r) {
    const Keyframe& keyframe = *references.keyframes[r];
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
  const Explanation best = best_explanation(current, attempt);
  if (best.is_another_motion || share_in(best.moving, current, *current_points_) >= kFew) {
    attempt = aligned_without(best.moving, current, attempt);
  }
  if (best.areas.moving_ratio() >= 1) {
    attempt.result.status = TrackingStatus::lost;
    attempt.result.reason = TrackingReason::two_motions;
  }
  if (attempt.result.status == TrackingStatus::lost) {
    use_points_outside(unusable(moving_tiles(expected_)), current);
    return attempt;
  }
  segmentation_.update(tile_depths_, best.log_odds);
  surfaces_.edged =
      surface_areas(best.log_odds, tile_depths_, tiles_with_points(current, *own_points_));
  forget_moved(attempt.references, best.evidence);
  return attempt;
}

}  // namespace vo
