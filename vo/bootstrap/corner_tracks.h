#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vo/image/pyramid.h"

namespace vo {

/// Corners of one frame, whose motion in the image is determined in both directions, followed from
/// frame to frame by their neighbourhood in that first frame (Lucas & Kanade 1981, coarse to fine).
class CornerTracks {
 public:
  /// Finds at most about `count` corners, the strongest of each cell of a grid.
  CornerTracks(const FramePyramid& first, int count);

  /// Follows all corners that are not lost yet, each from its last position.
  void follow(const FramePyramid& frame);

  std::size_t size() const { return start_.size(); }
  std::size_t alive() const;
  bool is_alive(std::size_t i) const { return alive_[i]; }
  const Eigen::Vector2d& start(std::size_t i) const { return start_[i]; }  ///< px, in first frame
  const Eigen::Vector2d& now(std::size_t i) const { return now_[i]; }      ///< px, if alive

 private:
  bool follow_one(std::size_t i, const FramePyramid& frame);

  FramePyramid first_;
  std::vector<Eigen::Vector2d> start_;
  std::vector<Eigen::Vector2d> now_;
  std::vector<bool> alive_;
};

}  // namespace vo
