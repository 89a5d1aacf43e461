#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "vo/alignment/align.h"
#include "vo/geometry/readout.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/segmentation/motion_segmentation.h"
#include "vo/segmentation/motion_support.h"
#include "vo/segmentation/tile_surfaces.h"
#include "vo/tracking/doubt.h"
#include "vo/tracking/local_map.h"
#include "vo/tracking/readout_estimate.h"
#include "vo/tracking/references.h"
#include "vo/tracking/tracker_options.h"
#include "vo/tracking/tracking_result.h"
#include "vo/tracking/vignette_estimate.h"
#include "vo/tracking/window_adjustment.h"

namespace vo {

/// Tracks frames against keyframes, wherever the depth of their points came from.
class Tracker {
 public:
  explicit Tracker(const TrackerOptions& options, SE3 T_world_first = {});

  /// Tracks a frame. Before there is a keyframe, a frame with enough edge pixels with depth is
  /// initialized at T_world_first and others are lost. After a lost frame the motion model starts
  /// from rest.
  TrackingResult track(const FramePyramid& current);

  /// Returns whether the frame of this result should become a keyframe: it is time for one, and the
  /// frame is fit to be one.
  bool needs_keyframe(const FramePyramid& current, const TrackingResult& result) const;
  /// Makes a frame a keyframe with points of its own depth, and adjusts the window if there is one.
  void set_keyframe(const FramePyramid& keyframe, const SE3& T_world_keyframe);

  /// Makes a frame a keyframe with points of a depth map instead of the frame's own depth, and
  /// adjusts the window if there is one.
  void set_keyframe(const FramePyramid& keyframe, const SE3& T_world_keyframe,
                    std::shared_ptr<const EdgePoints> points);
  /// Replaces the last keyframe's points by what the depth map knows of them by now.
  void update_keyframe(std::shared_ptr<const EdgePoints> points);
  const LocalMap& map() const { return map_; }

  /// Returns the read-out that is known by now.
  Readout readout() const { return align_options().readout; }

  /// Returns the motion while the last tracked frame, and the last keyframe, was read: none where
  /// the shutter is global or the velocity is not known.
  ReadoutMotion readout_motion() const { return readout_motion_at(velocity_); }
  ReadoutMotion keyframe_readout_motion() const { return readout_motion_at(map_.last()->velocity); }

  /// Returns the velocity that the next frame is expected to have, m/s and rad/s in its own frame:
  /// that between the last two. It is not known where nothing tells it or the last pose is doubted.
  std::optional<Vector6d> expected_velocity() const;

  /// Returns the vignette that is to be removed from the next frame.
  const Vignette& vignette() const { return vignette_.vignette(); }

  /// Returns what moves by itself in the last tracked frame.
  const MotionSegmentation& segmentation() const { return segmentation_; }

  /// Returns the first reference's points as aligned to the last frame; for pictures and tests.
  const EdgePoints& reference_points() const { return *reference_points_; }

 private:
  /// Where an alignment starts: at the pose that the motion model expects, or at one of those that
  /// a search tries.
  enum class Start { expected, searched };
  struct Guess {
    Start start = Start::expected;
    SE3 T_world_camera;
  };

  /// A frame aligned from one start, and what it was aligned with.
  struct Attempt {
    Start start = Start::expected;
    References references;
    std::optional<PreviousFrame> previous;  ///< where the motion since it is known
    TrackingResult result;

    /// Returns the pose that the alignment found, whether it is believed or not.
    SE3 T_world_camera() const {
      return references.keyframes.front()->T_world_keyframe * result.alignment.T_cur_ref.inverse();
    }
  };

  /// Holds what the tiles of a frame show if the frame's pose is that of an alignment.
  struct Explanation {
    AlignResult aligned;
    StaticEvidence evidence;
    TileEvidence log_odds{};
    TileMask moving = {};
    SurfaceAreas areas = {};
    bool is_another_motion = false;     ///< than that of all points together
    TileMask tiles = TileMask().set();  ///< those whose motion is taken for the camera's
  };

  /// The tiles whose motions rival that of all points.
  struct Rivals {
    bool are_contested = false;  ///< whether much moves, so that areas tell the motions apart
    InplaceVector<TileMask, 2> tiles;
  };

  TrackingResult begun(const FramePyramid& current);
  bool begins_anew(const FramePyramid& current);
  void find_current_points(const FramePyramid& current);
  SE3 starting_pose(const FramePyramid& current) const;
  AlignOptions align_options() const;
  ReadoutMotion readout_motion_at(const std::optional<FrameVelocity>& velocity) const;
  Attempt aligned_from(const FramePyramid& current, const Guess& guess);
  Attempt aligned_with(const FramePyramid& current, const Guess& guess, References references,
                       const EdgePoints* points);
  Attempt searched(const FramePyramid& current, Attempt first);
  References references_for(const FramePyramid& current, const SE3& T_world_guess) const;
  bool is_segmenting() const;
  void foresee_tiles(const FramePyramid& current);
  TileMask unusable(const TileMask& moving) const;
  void use_points_outside(const TileMask& tiles, const FramePyramid& current);
  Explanation explained(const FramePyramid& current, const References& references,
                        const std::optional<PreviousFrame>& previous, const AlignResult& aligned);
  void label(const TileEvidence& log_odds, Explanation& explanation) const;
  AlignResult aligned_in(const TileMask& tiles, const FramePyramid& current,
                         const Attempt& attempt);
  MotionSupport supported(const FramePyramid& current, const Attempt& attempt,
                          const Explanation& explanation) const;
  bool differs(const SE3& T_a_b, const FramePyramid& current) const;
  bool is_contested(const Explanation& explanation) const;
  Rivals rivals_of(const Explanation& explanation) const;
  Explanation best_explanation(const FramePyramid& current, Attempt& attempt);
  void forget_moved(const LocalMap::References& keyframes, const StaticEvidence& evidence);
  Attempt aligned_without(const TileMask& moving, const FramePyramid& current,
                          const Attempt& attempt);
  Attempt segmented(const FramePyramid& current, Attempt attempt);
  bool follows_motion(const Attempt& attempt) const;
  void calibrate(const FramePyramid& current, const Attempt& attempt);
  std::vector<WindowFrame> window(const std::vector<std::size_t>& keyframes) const;
  void adjust_keyframes();
  double depth_deviation_of(const FramePyramid& current, const Attempt& attempt) const;
  void judge_pose(const FramePyramid& current, Attempt& attempt);
  double correlation_of(const AlignResult& alignment, Start start) const;
  TrackingReason judge(const AlignResult& alignment, Start start) const;
  void accept(const FramePyramid& current, const Attempt& attempt);
  void tell_first_velocity();
  bool can_be_reference(const FramePyramid& frame) const;
  bool is_blurred(const FramePyramid& current, const SE3& T_cur_last) const;

  TrackerOptions options_;
  LocalMap map_;
  ReadoutEstimate readout_;
  VignetteEstimate vignette_;

  AlignMemory align_memory_;
  EdgePointFinder own_point_finder_;
  std::shared_ptr<const EdgePoints> reference_points_;
  std::shared_ptr<EdgePoints> own_points_;      ///< own points of the tracked frame, if symmetric
  std::shared_ptr<EdgePoints> fewer_points_;    ///< own points outside some tiles
  std::shared_ptr<EdgePoints> current_points_;  ///< those of them that are aligned

  Doubt doubt_;
  MotionSegmentation segmentation_;
  ViewSurfaces surfaces_;            ///< of the tracked frame
  ViewTiles::Values tile_depths_{};  ///< tile_depths() of the tracked frame, m
  TileMask covered_;                 ///< tiles of the tracked frame that something covers
  TileEvidence expected_{};  ///< log-odds that the tracked frame's tiles are static, beforehand
  int frames_since_keyframe_ = 0;
  bool is_lost_ = false;          ///< whether the last frame was lost
  bool is_sure_ = false;          ///< whether the last frame with a pose agreed with the map
  bool is_uncertain_ = false;     ///< whether the last frame's pose must not be relied on
  bool was_sure_ = false;         ///< whether some frame agreed with the map
  int lost_at_beginning_ = 0;     ///< lost frames since the map began, while no pose was sure
  int patience_ = 5;              ///< lost frames after which such a map begins anew
  bool depth_is_mapped_ = false;  ///< whether the points' depths were found with the tracked poses
  double last_timestamp_ = 0;     ///< s, of the last tracked frame
  SE3 T_world_last_;
  Matrix6d absolute_covariance_ = Matrix6d::Zero();  ///< of T_world_last_, as in TrackingResult
  SE3 T_last_predicted_;                       ///< motion expected from the last frame to the next
  std::optional<MeanVelocity> mean_velocity_;  ///< between the last two frames, if known
  std::optional<FrameVelocity> velocity_;      ///< at the last tracked frame, if known
};

}  // namespace vo
