#include "synth/shading/environment_light.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/shading/scrambled_sobol.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// An environment of a radiance that is a function of the direction.
template <typename Function>
Environment environment_of(Function radiance_from, int rows = 32) {
  Environment environment;
  environment.radiance.create(rows, 2 * rows);
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < 2 * rows; ++u) {
      const double colatitude = std::numbers::pi * (v + 0.5) / rows;
      const double longitude = std::numbers::pi * ((u + 0.5) / rows - 1);
      environment.radiance(v, u) =
          radiance_from(Vector3d(std::sin(colatitude) * std::sin(longitude), std::cos(colatitude),
                                 -std::sin(colatitude) * std::cos(longitude)));
    }
  }
  return environment;
}

/// A dim blue sky with a bright spot to the right of -z, above the horizon.
cv::Vec3f sky_with_sun(const Vector3d& direction) {
  const bool is_sun = direction.dot(Vector3d(0.6, 0.5, -0.6).normalized()) > 0.98;
  return is_sun ? cv::Vec3f(100, 90, 80) : cv::Vec3f(0.1F, 0.2F, direction.y() > 0 ? 0.5F : 0);
}

/// Calls `visit` for directions that are spread evenly over the sphere.
template <typename Visit>
void for_directions(int rows, Visit visit) {
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < 2 * rows; ++u) {
      const double y = 1 - 2 * (v + 0.5) / rows;
      const double longitude = std::numbers::pi * (u + 0.5) / rows;
      const double level = std::sqrt(1 - y * y);
      visit(Vector3d(level * std::sin(longitude), y, level * std::cos(longitude)).cast<float>());
    }
  }
}

TEST(EnvironmentLight, ShowsItsPixelsWhereTheImageSays) {
  const Environment environment = environment_of(
      [](const Vector3d& d) { return cv::Vec3f(static_cast<float>(d.x() + 2), 0, 0); });
  const EnvironmentLight light(environment);
  for_directions(20, [&](const Vector3f& direction) {
    EXPECT_NEAR(light.radiance(direction).x(), direction.x() + 2, 0.01);
  });
}

TEST(EnvironmentLight, TurnsAboutTheVertical) {
  Environment environment = environment_of(
      [](const Vector3d& d) { return cv::Vec3f(static_cast<float>(1 - d.z()), 0, 0); });
  environment.turn = std::numbers::pi / 2;  // from -z to -x
  EXPECT_NEAR(EnvironmentLight(environment).radiance(-Vector3f::UnitX()).x(), 2, 0.01);
}

TEST(EnvironmentLight, DensityIntegratesToOneAndIsThatOfWhatIsDrawn) {
  const Environment environment = environment_of(sky_with_sun);
  const EnvironmentLight light(environment);
  const EnvironmentDirections directions(light);
  double integral = 0;
  constexpr int kRows = 800;
  for_directions(kRows, [&](const Vector3f& direction) {
    integral += directions.density(direction) * 4 * std::numbers::pi / (2.0 * kRows * kRows);
  });
  EXPECT_NEAR(integral, 1, 2e-3);
}

TEST(EnvironmentLight, DrawnLightOverItsDensitySumsToAllOfIt) {
  Environment environment = environment_of(sky_with_sun);
  environment.turn = 1;
  const EnvironmentLight light(environment);
  const EnvironmentDirections directions(light);
  Vector3d integral = Vector3d::Zero();
  constexpr int kRows = 800;
  for_directions(kRows, [&](const Vector3f& direction) {
    integral +=
        light.radiance(direction).cast<double>() * 4 * std::numbers::pi / (2.0 * kRows * kRows);
  });
  Vector3d drawn = Vector3d::Zero();
  constexpr int kDraws = 1 << 14;
  for (int i = 0; i < kDraws; ++i) {
    const DrawnLight sample = directions.draw(scrambled_sobol(vo::mixed(3), i));
    ASSERT_GT(sample.density, 0);
    EXPECT_NEAR(sample.to_light.norm(), 1, 1e-5);
    drawn += (sample.radiance / sample.density).cast<double>() / kDraws;
  }
  EXPECT_TRUE(drawn.isApprox(integral, 5e-3)) << drawn.transpose() << " " << integral.transpose();
}

TEST(EnvironmentIrradiance, OfALinearSkyIsTheClosedForm) {
  const Environment environment = environment_of(
      [](const Vector3d& d) { return cv::Vec3f::all(static_cast<float>(1 + 0.5 * d.y())); }, 128);
  const EnvironmentIrradiance irradiance(environment);
  for_directions(8, [&](const Vector3f& normal) {
    EXPECT_NEAR(irradiance(normal).x(),
                std::numbers::pi + 0.5 * 2 * std::numbers::pi / 3 * normal.y(), 2e-3);
  });
}

}  // namespace
}  // namespace synth
