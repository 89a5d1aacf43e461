#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"
#include "vo/mapping/hypotheses.h"

namespace vo {

/// A host with what its map knew when the map was carried on.
struct PastMap {
  FramePyramid host;
  Hypotheses hypotheses;
  SE3 T_world_host;
  ReadoutMotion motion;  ///< motion while the host was read
};

/// The scale of a map relative to that of an earlier host's map.
struct RelativeScale {
  double log_scale = 0;   ///< natural logarithm of the later depths over the earlier ones
  double sigma = 0;       ///< standard deviation of log_scale
  std::size_t edges = 0;  ///< number of edges that both hosts know
};

/// Returns what the edges that two hosts share say of their maps' relative scale, or nothing where
/// they share too few: the median ratio of depths, with the deviation that the ratios' spread
/// shows.
std::optional<RelativeScale> relative_scale(const PastMap& earlier, const PastMap& later);

/// The scale of a map as it is known relative to that of the first.
struct ScaleEstimate {
  double drift = 0;       ///< natural logarithm of the map's depths over those of the first map
  double sigma = 0;       ///< standard deviation of drift
  double correction = 0;  ///< what the map's logarithmic scale must change by; 0 almost always
};

/// Follows the scale of a map from host to host. Each step's drift is the relative scale of two
/// consecutive maps; where an earlier host still shows, or shows again, what the last one does, a
/// Kalman filter takes in that relative scale, too.
class ScaleWatch {
 public:
  /// Takes the standard deviation of the first map's logarithmic scale from place to place: 0 where
  /// its depths were measured.
  explicit ScaleWatch(double first_sigma = 0) { scale_.sigma = first_sigma; }

  /// Compares a map with the one before and with the earliest one that overlaps, and keeps it.
  /// The correction is the opposite of the drift since a place that is seen again, where that is
  /// significant; the caller must make it.
  const ScaleEstimate& add(PastMap map);

  /// Takes up a map that was begun elsewhere, once the pose of its host is known among the past
  /// maps. Returns the natural logarithm of its depths over those of the past map that tells it
  /// best, after which it counts as corrected; or nothing where none tells it well.
  std::optional<double> take_up(const PastMap& map);

  /// Begins a map whose scale is a guess.
  void lose_scale();

  const ScaleEstimate& scale() const { return scale_; }  ///< of the last map

 private:
  struct Kept {
    PastMap map;
    ScaleEstimate scale;
  };

  void carry(const PastMap& map);
  void look_back(const PastMap& map);

  std::deque<Kept> past_;  ///< oldest first
  ScaleEstimate scale_;
};

}  // namespace vo
