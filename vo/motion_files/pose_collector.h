#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "vo/core/error.h"
#include "vo/geometry/trajectory.h"

namespace vo {

/// Makes a trajectory of poses in the order in which a file has them. Of several with one stamp the
/// first counts; stamps that go back by at most `kMaxDisorder` are put in order. Notes say how
/// many.
class PoseCollector {
 public:
  static constexpr double kMaxDisorder = 0.5;  ///< s

  /// The order of a file's poses.
  enum class Order {
    of_time,  ///< but for mistakes
    none      ///< the order means nothing
  };

  PoseCollector(std::filesystem::path path, Order order);

  void reserve(std::size_t poses) { poses_.reserve(poses); }

  /// Adds the pose of a line, or of what else has a `place()`. Throws Error if its stamp is more
  /// than `kMaxDisorder` before one that came earlier in a file in the order of time.
  template <typename Place>
  void add(const StampedPose& pose, const Place& where) {
    const double back = take(pose);
    if (order_ == Order::of_time && back > kMaxDisorder) {
      fail(where.place(), ": expected a stamp after the ones before it, or up to ", kMaxDisorder,
           " s earlier, got one that is ", back, " s earlier");
    }
  }

  /// Returns the trajectory and appends to `notes`. Throws Error if there are no poses.
  Trajectory finish(std::vector<std::string>& notes);

 private:
  /// Adds a pose; returns by how much its stamp, s, is before the latest.
  double take(const StampedPose& pose);

  std::filesystem::path path_;
  Order order_;
  Trajectory poses_;
  double latest_ = 0;           ///< s, of the stamps so far
  double most_disorder_ = 0;    ///< s, greatest distance of a stamp from a later one before it
  std::size_t disordered_ = 0;  ///< poses with a stamp before one that came earlier
};

}  // namespace vo
