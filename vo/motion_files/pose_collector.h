#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/text_files/text_lines.h"

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

  /// Adds the pose of a line. Throws Error if its stamp is more than `kMaxDisorder` before one that
  /// came earlier in a file in the order of time.
  void add(const StampedPose& pose, const TextLine& line);

  /// Returns the trajectory and appends to `notes`. Throws Error if there are no poses.
  Trajectory finish(std::vector<std::string>& notes);

 private:
  std::filesystem::path path_;
  Order order_;
  Trajectory poses_;
  double latest_ = 0;           ///< s, of the stamps so far
  double most_disorder_ = 0;    ///< s, greatest distance of a stamp from a later one before it
  std::size_t disordered_ = 0;  ///< poses with a stamp before one that came earlier
};

}  // namespace vo
