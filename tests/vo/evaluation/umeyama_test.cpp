#include "vo/evaluation/umeyama.h"

#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace vo {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kUmeyamaTolerance = 1e-12;  // m, and of matrix entries and scales

Points random_points(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Points points(count);
  for (Eigen::Vector3d& point : points) {
    point = {normal(random), normal(random), normal(random)};
  }
  return points;
}

Points mapped(const Similarity& similarity, const Points& points) {
  Points result;
  for (const Eigen::Vector3d& point : points) {
    result.emplace_back(similarity * point);
  }
  return result;
}

Similarity example_similarity(double scale) {
  const Eigen::AngleAxisd rotation(2.5, Eigen::Vector3d(1, -2, 3).normalized());
  return {rotation.toRotationMatrix(), {4, -5, 6}, scale};
}

double squared_error(const Similarity& similarity, const Points& source, const Points& target) {
  double sum = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    sum += (similarity * source[i] - target[i]).squaredNorm();
  }
  return sum;
}

bool is_proper_rotation(const Eigen::Matrix3d& R) {
  return (R * R.transpose()).isIdentity(kUmeyamaTolerance) &&
         std::abs(R.determinant() - 1) < kUmeyamaTolerance;
}

TEST(Umeyama, RecoversAKnownSimilarity) {
  const Similarity truth = example_similarity(1.7);
  const Points source = random_points(20, 1);
  const Similarity found = fit_similarity(source, mapped(truth, source));
  EXPECT_TRUE(found.rotation.isApprox(truth.rotation, kUmeyamaTolerance));
  EXPECT_TRUE(found.translation.isApprox(truth.translation, kUmeyamaTolerance));
  EXPECT_NEAR(found.scale, truth.scale, kUmeyamaTolerance);
}

TEST(Umeyama, RecoversAKnownRigidMotion) {
  const Similarity truth = example_similarity(1);
  const Points source = random_points(20, 2);
  const Similarity found = fit_rigid(source, mapped(truth, source));
  EXPECT_TRUE(found.rotation.isApprox(truth.rotation, kUmeyamaTolerance));
  EXPECT_TRUE(found.translation.isApprox(truth.translation, kUmeyamaTolerance));
  EXPECT_EQ(found.scale, 1);
}

TEST(Umeyama, RecoversAMotionInAPlane) {
  const Similarity truth = example_similarity(0.3);
  Points source = random_points(20, 3);
  for (Eigen::Vector3d& point : source) {
    point.z() = 1;
  }
  const Similarity found = fit_similarity(source, mapped(truth, source));
  EXPECT_TRUE(found.rotation.isApprox(truth.rotation, kUmeyamaTolerance));
  EXPECT_NEAR(found.scale, truth.scale, kUmeyamaTolerance);
}

TEST(Umeyama, HasTheLeastSquaredErrorOfAllNearbySimilarities) {
  const Points source = random_points(20, 4);
  const Points target = random_points(20, 5);
  const Similarity best = fit_similarity(source, target);
  const double least = squared_error(best, source, target);
  for (const double step : {-1e-3, 1e-3}) {  // rad, m and of the scale
    for (int axis = 0; axis < 3; ++axis) {
      Similarity other = best;
      other.rotation = Eigen::AngleAxisd(step, Eigen::Vector3d::Unit(axis)) * best.rotation;
      EXPECT_GT(squared_error(other, source, target), least);
      other = best;
      other.translation += step * Eigen::Vector3d::Unit(axis);
      EXPECT_GT(squared_error(other, source, target), least);
    }
    Similarity other = best;
    other.scale += step;
    EXPECT_GT(squared_error(other, source, target), least);
  }
}

TEST(Umeyama, FindsAProperRotationOfMirroredPoints) {
  const Points source = random_points(20, 6);
  Points target = source;
  for (Eigen::Vector3d& point : target) {
    point.x() = -point.x();
  }
  EXPECT_TRUE(is_proper_rotation(fit_rigid(source, target).rotation));
}

TEST(Umeyama, FitsPointsOnALine) {
  const Similarity truth = example_similarity(2);
  Points source;
  for (int i = 0; i < 5; ++i) {
    source.emplace_back(Eigen::Vector3d(1, 2, 3) + i * Eigen::Vector3d(0.1, -0.2, 0.3));
  }
  const Points target = mapped(truth, source);
  const Similarity found = fit_similarity(source, target);
  EXPECT_TRUE(is_proper_rotation(found.rotation));
  EXPECT_NEAR(found.scale, truth.scale, kUmeyamaTolerance);
  EXPECT_LT(squared_error(found, source, target), kUmeyamaTolerance * kUmeyamaTolerance);
}

TEST(Umeyama, FitsPointsThatCoincide) {
  const Points source(7, Eigen::Vector3d(0.1, 0.2, 0.3));
  const Points target(7, Eigen::Vector3d(1, 2, 3));
  const Similarity found = fit_similarity(source, target);
  EXPECT_TRUE(is_proper_rotation(found.rotation));
  EXPECT_EQ(found.scale, 1);
  EXPECT_LT(squared_error(found, source, target), kUmeyamaTolerance * kUmeyamaTolerance);
}

TEST(Umeyama, KeepsTheScaleOfAMovingSourceWithAStandingTarget) {
  const Points source{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  const Points target(4, Eigen::Vector3d(4, 5, 6));
  const Similarity found = fit_similarity(source, target);
  EXPECT_TRUE(is_proper_rotation(found.rotation));
  EXPECT_EQ(found.scale, 1);
  const double spread = (1 + 4 + 9) * 0.75;  // of the source about its mean
  EXPECT_NEAR(squared_error(found, source, target), spread, 1e-12);
}

TEST(Umeyama, KeepsTheScaleOfAStandingSourceWithAMovingTarget) {
  const Points source(20, Eigen::Vector3d(0.1, 0.2, 0.3));
  const Similarity found = fit_similarity(source, random_points(20, 7));
  EXPECT_TRUE(is_proper_rotation(found.rotation));
  EXPECT_EQ(found.scale, 1);
}

}  // namespace
}  // namespace vo
