#include "vo/evaluation/umeyama.h"

#include <cassert>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace vo {
namespace {

/// Points coincide if their standard deviation is below this share of their mean's distance from
/// the origin.
constexpr double kRounding = 1e-12;

struct Moments {
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d target_mean = Eigen::Vector3d::Zero();
  double source_variance = 0;
  double target_variance = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< mean of centred target times source^T
};

Eigen::Vector3d mean(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    sum += point;
  }
  return sum / static_cast<double>(points.size());
}

Moments moments(std::span<const Eigen::Vector3d> source, std::span<const Eigen::Vector3d> target) {
  assert(!source.empty() && source.size() == target.size());
  Moments result;
  result.source_mean = mean(source);
  result.target_mean = mean(target);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Eigen::Vector3d centred_source = source[i] - result.source_mean;
    const Eigen::Vector3d centred_target = target[i] - result.target_mean;
    result.source_variance += centred_source.squaredNorm();
    result.target_variance += centred_target.squaredNorm();
    result.covariance += centred_target * centred_source.transpose();
  }
  result.source_variance /= static_cast<double>(source.size());
  result.target_variance /= static_cast<double>(source.size());
  result.covariance /= static_cast<double>(source.size());
  return result;
}

bool coincide(double variance, const Eigen::Vector3d& mean) {
  return variance <= kRounding * kRounding * mean.squaredNorm();
}

enum class Scale { fixed, fitted };

/// Fits by equations (39) to (42) of Umeyama's paper.
Similarity fit(const Moments& moments, Scale scale) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments.covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) {
    signs.z() = -1;
  }
  const bool has_scale = !coincide(moments.source_variance, moments.source_mean) &&
                         !coincide(moments.target_variance, moments.target_mean);
  Similarity result;
  result.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  if (scale == Scale::fitted && has_scale) {
    result.scale = svd.singularValues().dot(signs) / moments.source_variance;
  }
  result.translation = moments.target_mean - result.scale * (result.rotation * moments.source_mean);
  return result;
}

}  // namespace

Eigen::Vector3d operator*(const Similarity& similarity, const Eigen::Vector3d& point) {
  return similarity.scale * (similarity.rotation * point) + similarity.translation;
}

Similarity fit_rigid(std::span<const Eigen::Vector3d> source,
                     std::span<const Eigen::Vector3d> target) {
  return fit(moments(source, target), Scale::fixed);
}

Similarity fit_similarity(std::span<const Eigen::Vector3d> source,
                          std::span<const Eigen::Vector3d> target) {
  return fit(moments(source, target), Scale::fitted);
}

}  // namespace vo
