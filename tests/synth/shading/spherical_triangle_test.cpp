#include "synth/shading/spherical_triangle.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;
using Corners = std::array<Vector3f, 3>;

/// Triangles about the origin: large and small, thin, and one that almost fills a hemisphere.
std::vector<Corners> triangles() {
  return {
      {Vector3f(1, 0, 0), Vector3f(0, 2, 0), Vector3f(0, 0, 3)},
      {Vector3f(1, 0, 5), Vector3f(0, 0.5F, 5), Vector3f(-0.5F, -1, 6)},
      {Vector3f(-0.31F, -0.3F, 0.01F), Vector3f(0.29F, -0.3F, 0.01F), Vector3f(0.29F, 0.3F, 0.01F)},
      {Vector3f(0.01F, -0.3F, 0.01F), Vector3f(0.61F, -0.3F, 0.01F), Vector3f(0.61F, 0.3F, 0.01F)},
      {Vector3f(-1, -1, 0.05F), Vector3f(1, -1, 0.05F), Vector3f(0, 1, 0.05F)}};
}

/// Returns the integral of the direction over a triangle's solid angle (Lambert): half the sum over
/// the edges of their angle times the unit normal of their plane.
Vector3d vector_irradiance(const Corners& corners) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d a = corners[i].cast<double>().normalized();
    const Vector3d b = corners[(i + 1) % 3].cast<double>().normalized();
    const Vector3d normal = a.cross(b);
    sum += std::atan2(normal.norm(), a.dot(b)) / 2 * normal.normalized();
  }
  const Vector3d inwards = (corners[0] + corners[1] + corners[2]).cast<double>();
  return sum.dot(inwards) < 0 ? Vector3d(-sum) : sum;
}

TEST(SphericalTriangle, AnOctantIsAnEighthOfTheSphere) {
  EXPECT_FLOAT_EQ(SphericalTriangle(triangles()[0]).solid_angle(), std::numbers::pi_v<float> / 2);
}

TEST(SphericalTriangle, TheMeanDirectionIsTheClosedForm) {
  constexpr int kRoot = 100;
  for (const Corners& corners : triangles()) {
    const SphericalTriangle triangle(corners);
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < kRoot * kRoot; ++i) {
      const Vector2f square((static_cast<float>(i / kRoot) + 0.5F) / kRoot,
                            (static_cast<float>(i % kRoot) + 0.5F) / kRoot);
      const Vector3f direction = triangle.direction(square);
      EXPECT_NEAR(direction.norm(), 1, 1e-5);
      sum += direction.cast<double>();
    }
    const Vector3d found = sum * (triangle.solid_angle() / (kRoot * kRoot));
    EXPECT_TRUE(found.isApprox(vector_irradiance(corners), 5e-4))
        << found.transpose() << " instead of " << vector_irradiance(corners).transpose();
  }
}

TEST(SphericalTriangle, EveryPartOfTheSquareGoesToAnEqualSolidAngle) {
  for (const Corners& corners : triangles()) {
    const SphericalTriangle triangle(corners);
    const Vector3f apex = triangle.direction({0.5F, 1});
    const SphericalTriangle half({corners[0], corners[1], apex});
    EXPECT_NEAR(half.solid_angle(), triangle.solid_angle() / 2, 1e-4F * triangle.solid_angle());
  }
}

}  // namespace
}  // namespace synth
