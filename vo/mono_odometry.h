#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "vo/core/camera.h"
#include "vo/core/image.h"
#include "vo/core/trajectory.h"
#include "vo/mapping/depth_map.h"
#include "vo/mapping/mono_initialiser.h"
#include "vo/odometry.h"
#include "vo/tracking/tracker.h"

namespace vo {

/// Where the first depths come from.
enum class MonoBootstrap {
  rgbd,       ///< the depth image of the first frame: metric
  file,       ///< a depth image that somebody else made, given with the first frame
  flat,       ///< one depth everywhere, found wrong by the observations
  random,     ///< random depths, likewise
  automatic,  ///< first frame held until parallax tells structure and motion at once
};

constexpr auto enum_names(MonoBootstrap) {
  return std::array{std::pair{MonoBootstrap::rgbd, "rgbd"}, std::pair{MonoBootstrap::file, "file"},
                    std::pair{MonoBootstrap::flat, "flat"},
                    std::pair{MonoBootstrap::random, "random"},
                    std::pair{MonoBootstrap::automatic, "auto"}};
}

enum class MonoState { initialising, tracking, lost, reinitialising };

constexpr auto enum_names(MonoState) {
  return std::array{std::pair{MonoState::initialising, "initialising"},
                    std::pair{MonoState::tracking, "tracking"}, std::pair{MonoState::lost, "lost"},
                    std::pair{MonoState::reinitialising, "reinitialising"}};
}

struct MonoOptions {
  MonoBootstrap bootstrap = MonoBootstrap::automatic;
  double start_depth = 1;     ///< m, of a flat start; the median of an unknown one
  double start_sigma = 0.01;  ///< relative, of given depths
  std::uint64_t seed = 0;     ///< of random depths
  int min_confident = 150;    ///< hypotheses; fewer and the map is lost
  int max_lost_frames = 15;   ///< in a row; then a new map is started
  double parallax_px = 4;     ///< median, at 640 px width, that ends an unknown start
  TrackerOptions tracker;
  DepthMapOptions map;

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, MonoOptions& options) {
  visit("bootstrap", options.bootstrap, "where the first depths come from");
  visit("start_depth", options.start_depth, "flat start; median of an unknown one, m");
  visit("start_sigma", options.start_sigma, "of given depths, relative");
  visit("seed", options.seed, "of random depths");
  visit("min_confident", options.min_confident, "fewer confident hypotheses are a lost map");
  visit("max_lost_frames", options.max_lost_frames, "in a row, then a new map is started");
  visit("parallax_px", options.parallax_px,
        "median parallax that ends an unknown start, px at 640 px width");
  visit_fields(visit, options.tracker);
  visit("depth_map", options.map, "");
}

/// The tracker's best values for a map of its own making: no depth image to look up or to judge
/// with, hence not symmetric; points are weighted by what the map knows.
MonoOptions mono_options();

/// What one frame gave.
struct MonoResult {
  TrackingResult tracking;
  MonoState state = MonoState::initialising;  ///< after the frame
  InitialiserReport initialiser;              ///< parallax meter; while initialising
  std::size_t hypotheses = 0;
  std::size_t confident = 0;
  ObservationCounts observations;
};

/// Monocular edge-direct odometry: the tracker of the RGB-D odometry on an inverse-depth map that
/// is kept, observed with each frame and propagated.
class MonoOdometry {
 public:
  explicit MonoOdometry(const PinholeCamera& camera, const MonoOptions& options = mono_options(),
                        const SE3& T_world_first = {});

  /// The frame's depth is read once, for a bootstrap that asks for it, and never again; later
  /// frames need none. Throws Error when an image has another size than the camera, or the first
  /// frame lacks the depth that the bootstrap needs.
  MonoResult track(const RgbdFrame& frame);

  const Trajectory& trajectory() const { return trajectory_; }  ///< frames that are not lost
  const StageTimes& stage_times() const { return stage_times_; }
  const DepthMap& map() const { return map_; }
  const SE3& T_world_anchor() const { return T_world_anchor_; }
  const FramePyramid& current() const { return current_; }
  const Tracker& tracker() const { return *tracker_; }

 private:
  void start_from_depth(const DepthImage& depth, MonoResult& result);
  void start_from_guesses(MonoResult& result);
  void initialise(MonoResult& result);
  void map_first_frame(const MonoInitialiser& solved);
  void track_again(const MonoInitialiser& solved, MonoResult& result);
  void begin_tracking(const FramePyramid& anchor, Guesses guesses, MonoResult& result);
  void follow(MonoResult& result);
  FrameRelation relation_to_anchor(const TrackingResult& tracked) const;
  void update_map(MonoResult& result);
  void reinitialise();
  std::shared_ptr<const EdgePoints> tracked_points() const;

  PinholeCamera camera_;
  MonoOptions options_;
  EdgeFinder edge_finder_;
  std::vector<CameraLevel> levels_;
  std::unique_ptr<Tracker> tracker_;
  std::unique_ptr<MonoInitialiser> initialiser_;  ///< while initialising
  DepthMap map_;
  Guesses guesses_ = Guesses::left_out;  ///< whether they are tracked with, too
  double start_depth_ = 1;               ///< m, median depth of an unknown start
  SE3 T_world_anchor_;
  FramePyramid current_;
  MonoState state_ = MonoState::initialising;
  bool is_first_ = true;
  int lost_frames_ = 0;
  Trajectory trajectory_;
  StageTimes stage_times_;
};

}  // namespace vo
