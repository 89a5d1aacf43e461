#pragma once

#include <vector>

#include <Eigen/Core>

#include "tools/train_edges/edge_patch.h"

namespace tools {

/// One row a patch, one column a line: 1 where the patch has an edge on the line, else 0.
Eigen::MatrixXf separations(const std::vector<EdgePatch>& patches,
                            const std::vector<EdgePatch>& lines);

/// Divides patches in two classes of like edges: by the sign of the first principal component of
/// their separations. Empty when all are alike.
std::vector<bool> two_classes(const Eigen::MatrixXf& separations);

/// The row nearest to the mean of all.
std::size_t medoid(const Eigen::MatrixXf& separations);

}  // namespace tools
