#pragma once

#include <vector>

#include <Eigen/Core>

#include "tools/train_edges/edge_patch.h"

namespace tools {

/// Returns a matrix with a row per patch and a column per line: 1 where an edge of the patch
/// crosses the line, else 0.
Eigen::MatrixXf separations(const std::vector<EdgePatch>& patches,
                            const std::vector<EdgePatch>& lines);

/// Divides patches into two classes of similar edges by the sign of the first principal component
/// of their separations. It is empty when all are alike.
std::vector<bool> two_classes(const Eigen::MatrixXf& separations);

/// Returns the index of the row nearest to the mean of all rows.
std::size_t medoid(const Eigen::MatrixXf& separations);

}  // namespace tools
