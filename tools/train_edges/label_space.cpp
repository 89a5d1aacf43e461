#include "tools/train_edges/label_space.h"

#include <cstddef>

namespace tools {

Eigen::MatrixXf separations(const std::vector<EdgePatch>& patches,
                            const std::vector<EdgePatch>& lines) {
  Eigen::MatrixXf result(patches.size(), lines.size());
  for (std::size_t j = 0; j < lines.size(); ++j) {
    for (std::size_t i = 0; i < patches.size(); ++i) {
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (patches[i] & lines[j]).any() ? 1.0F : 0.0F;
    }
  }
  return result;
}

std::vector<bool> two_classes(const Eigen::MatrixXf& separations) {
  constexpr int kIterations = 12;  // power iterations; a rough direction suffices
  constexpr float kAlike = 1e-4F;
  const Eigen::MatrixXf centred = separations.rowwise() - separations.colwise().mean();
  Eigen::VectorXf component = centred.colwise().squaredNorm();
  if (!(component.sum() > kAlike * static_cast<float>(centred.size()))) {
    return {};
  }
  // The start is the row farthest from the mean, never orthogonal to the principal component.
  Eigen::Index farthest = 0;
  centred.rowwise().squaredNorm().maxCoeff(&farthest);
  component = centred.row(farthest).transpose().normalized();
  for (int i = 0; i < kIterations; ++i) {
    component = (centred.transpose() * (centred * component)).normalized();
  }
  const Eigen::VectorXf scores = centred * component;
  std::vector<bool> classes;
  for (const float score : scores) {
    classes.push_back(score > 0);
  }
  return classes;
}

std::size_t medoid(const Eigen::MatrixXf& separations) {
  Eigen::Index nearest = 0;
  (separations.rowwise() - separations.colwise().mean()).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<std::size_t>(nearest);
}

}  // namespace tools
