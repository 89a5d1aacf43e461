#pragma once

#include <cstddef>
#include <deque>
#include <functional>

#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/mapping/depth_map_options.h"
#include "vo/mapping/epipolar_search.h"
#include "vo/mapping/hypotheses.h"
#include "vo/mapping/map_points.h"
#include "vo/mapping/propagate.h"
#include "vo/mapping/stereo_pair.h"

namespace vo {

/// The number of edges that were looked for in a frame, by outcome.
struct ObservationCounts {
  std::size_t found = 0;
  std::size_t inconsistent = 0;  ///< found, but not where the depth was expected
  std::size_t out_of_view = 0;
  std::size_t unobservable = 0;
  std::size_t ambiguous = 0;
  std::size_t no_match = 0;
};

/// Called with each observation before it is fused; for tests and diagnostics.
using ObservationListener = std::function<void(std::size_t hypothesis, const Observation&)>;

/// The inverse depths of one frame's edge pixels with their uncertainty. That frame is the host; it
/// is kept (`observe` with each frame) until the map is carried to a new one (`propagate`).
///
/// The scale is that of the first depths and the poses; metres are nominal.
class DepthMap {
 public:
  explicit DepthMap(const DepthMapOptions& options);

  /// Starts at a new host, with edges, whose depths are unknown but for a guess, m.
  void start(const FramePyramid& host, double guessed_depth);

  /// Sets the depths from a dense depth image of the host's size with a relative standard
  /// deviation; edge pixels where it has none are left as they are.
  void take_depth(const DepthImage& depth, double relative_sigma);

  /// Sets random guesses between the options' limits, uniform in inverse depth.
  void guess_random(std::uint64_t seed);

  /// Takes the depths that an adjustment found for the finest points of `points()`. The other
  /// edges' depths change as those do in the median; what is known of their uncertainty stays.
  void correct(const EdgePointLevel& points);

  /// Removes a vignette from the host's image where it makes a difference.
  void take_out(const Vignette& vignette);

  /// Multiplies all depths by a factor.
  void rescale(double factor);

  ObservationCounts observe(const FramePyramid& current, const FrameRelation& relation,
                            const ObservationListener& listener = {});

  /// Smooths along the edges and forgets what disagrees with its neighbours.
  void regularise();

  /// Makes the current frame, with edges, the host. Where every frame becomes the host, its edges
  /// are also looked for in the earliest past host of a similar view, because there is hardly any
  /// parallax from frame to frame.
  PropagationCounts propagate(const FramePyramid& current, const FrameRelation& relation);

  /// Returns whether it is time for a new host, as the options say.
  bool needs_new_host(const FramePyramid& current, const SE3& T_cur_host) const;

  /// Returns the confident depths, and guesses if they are included, as the tracker's points.
  EdgePoints points(const EdgePointOptions& options, Guesses guesses = Guesses::left_out) const;

  bool empty() const { return host_.levels.empty(); }
  const FramePyramid& host() const { return host_; }
  const Hypotheses& hypotheses() const { return hypotheses_; }
  std::size_t confident() const;  ///< number of confident hypotheses

 private:
  SearchTarget target(std::size_t i) const;
  void count_and_fuse(const Observation& observation, std::size_t i, float guess,
                      ObservationCounts& counts);
  bool view_has_changed(const FramePyramid& current, const SE3& T_cur_host) const;
  void look_back(FramePyramid last_host, const FrameRelation& relation);

  struct PastHost {
    FramePyramid frame;
    SE3 T_past_host;
  };

  DepthMapOptions options_;
  FramePyramid host_;
  std::deque<PastHost> past_hosts_;  ///< oldest first; only where every frame becomes the host
  Hypotheses hypotheses_;
  PointCells cells_;  ///< cells of the host for the tracker's points
  int frames_since_host_ = 0;
};

}  // namespace vo
