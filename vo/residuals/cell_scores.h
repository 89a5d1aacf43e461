#pragma once

#include <vector>

#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"
#include "vo/residuals/point_pass.h"

namespace vo {

/// The points' terms of b, summed by the cell of the image that a point lies in, 16 cells to a row
/// of the image. Errors of neighbouring pixels are alike (a displaced edge, interpolation, wrong
/// depth); those of different cells are taken as independent.
class CellScores {
 public:
  /// Maps a pair's b of pose, gain and offset to the b of the pose alone.
  using Projection = Eigen::Matrix<double, 6, 8>;

  /// Starts anew, with no points, for images of this camera.
  void reset(const PinholeCamera& camera);

  void add(const PointTerms& scores, const Projection& projection);
  void add(float u, float v, const Vector6d& b);  ///< adds b at (u, v), px

  const std::vector<Vector6d>& b() const { return b_; }  ///< each cell's sum, row by row

 private:
  std::size_t cell_of(float u, float v) const;

  float cell_px_ = 1;
  std::vector<Vector6d> b_;
  std::vector<PointEquations::Vector> sums_;  ///< of the points that are being added
};

}  // namespace vo
