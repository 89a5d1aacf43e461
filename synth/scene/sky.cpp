#include "synth/scene/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "vo/core/error.h"
#include "vo/geometry/equirectangular.h"

namespace synth {
namespace {

using std::numbers::pi;

constexpr int kRows = 256;  // of the image
constexpr double kGroundAlbedo = 0.2;

/// The coefficients A to E of Perez' distribution of one coordinate of colour.
using Perez = std::array<double, 5>;

/// The sky's colour as luminance Y, kcd/m^2, and chromaticity x, y (CIE 1931).
struct SkyColour {
  double Y;
  double x;
  double y;
};

Perez perez_of(const std::array<double, 5>& per_turbidity, const std::array<double, 5>& constant,
               double turbidity) {
  Perez result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result.at(i) = per_turbidity.at(i) * turbidity + constant.at(i);
  }
  return result;
}

/// Returns Perez' distribution for the cosine of the angle from the zenith and the angle from the
/// sun, rad.
double perez(const Perez& p, double cos_zenith, double from_sun) {
  const double cos_sun = std::cos(from_sun);
  return (1 + p[0] * std::exp(p[1] / cos_zenith)) *
         (1 + p[2] * std::exp(p[3] * from_sun) + p[4] * cos_sun * cos_sun);
}

/// Returns a chromaticity of the zenith: a polynomial of degree 2 of the turbidity, the highest
/// power first, of polynomials of degree 3 of the sun's angle from the zenith, rad.
double zenith_chromaticity(const std::array<std::array<double, 4>, 3>& table, double turbidity,
                           double sun) {
  double result = 0;
  for (const std::array<double, 4>& row : table) {
    result = result * turbidity + ((row[0] * sun + row[1]) * sun + row[2]) * sun + row[3];
  }
  return result;
}

/// The model's sky for one place of the sun.
class PreethamSky {
 public:
  PreethamSky(double turbidity, double sun_from_zenith)
      : sun_(sun_from_zenith),
        luminance_(perez_of({0.1787, -0.3554, -0.0227, 0.1206, -0.0670},
                            {-1.4630, 0.4275, 5.3251, -2.5771, 0.3703}, turbidity)),
        x_(perez_of({-0.0193, -0.0665, -0.0004, -0.0641, -0.0033},
                    {-0.2592, 0.0008, 0.2125, -0.8989, 0.0452}, turbidity)),
        y_(perez_of({-0.0167, -0.0950, -0.0079, -0.0441, -0.0109},
                    {-0.2608, 0.0092, 0.2102, -1.6537, 0.0529}, turbidity)) {
    const double chi = (4.0 / 9 - turbidity / 120) * (pi - 2 * sun_);
    zenith_.Y = (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
    zenith_.x = zenith_chromaticity({{{0.00166, -0.00375, 0.00209, 0},
                                      {-0.02903, 0.06377, -0.03202, 0.00394},
                                      {0.11693, -0.21196, 0.06052, 0.25886}}},
                                    turbidity, sun_);
    zenith_.y = zenith_chromaticity({{{0.00275, -0.00610, 0.00317, 0},
                                      {-0.04214, 0.08970, -0.04153, 0.00516},
                                      {0.15346, -0.26756, 0.06670, 0.26688}}},
                                    turbidity, sun_);
  }

  SkyColour colour(double cos_zenith, double from_sun) const {
    return {zenith_.Y * relative(luminance_, cos_zenith, from_sun),
            zenith_.x * relative(x_, cos_zenith, from_sun),
            zenith_.y * relative(y_, cos_zenith, from_sun)};
  }

 private:
  double relative(const Perez& p, double cos_zenith, double from_sun) const {
    return perez(p, cos_zenith, from_sun) / perez(p, 1, sun_);
  }

  double sun_;  ///< rad from the zenith
  Perez luminance_;
  Perez x_;
  Perez y_;
  SkyColour zenith_{};
};

/// Returns linear RGB of sRGB's primaries, at least 0, in units of Y.
Eigen::Vector3d rgb_of(const SkyColour& colour) {
  const double X = colour.Y * colour.x / colour.y;
  const double Z = colour.Y * (1 - colour.x - colour.y) / colour.y;
  const Eigen::Vector3d rgb(3.2406 * X - 1.5372 * colour.Y - 0.4986 * Z,
                            -0.9689 * X + 1.8758 * colour.Y + 0.0415 * Z,
                            0.0557 * X - 0.2040 * colour.Y + 1.0570 * Z);
  return rgb.cwiseMax(0.0);
}

/// Returns the sun's light on a surface that faces it, klx, linear RGB: clean air scatters blue
/// away more than red (Rayleigh, at 680, 550 and 440 nm), haze all colours alike.
Eigen::Vector3d sunlight(const SkyOptions& options) {
  constexpr double kAbove = 128;  // klx, outside the atmosphere
  const double elevation_deg = options.sun_elevation * 180 / pi;
  const double air_mass =
      1 / (std::sin(options.sun_elevation) + 0.50572 * std::pow(elevation_deg + 6.07995, -1.6364));
  const Eigen::Vector3d clean(0.041, 0.098, 0.245);
  const Eigen::Vector3d thickness = clean.array() + (options.turbidity - 1) * clean.y();
  return kAbove * (-air_mass * thickness.array()).exp();
}

/// Returns the unit direction of a pixel's centre.
Eigen::Vector3d direction_of(int v, int u) {
  const double colatitude = pi * (v + 0.5) / kRows;
  const double longitude = pi * ((u + 0.5) / kRows - 1);
  return {std::sin(colatitude) * std::sin(longitude), std::cos(colatitude),
          -std::sin(colatitude) * std::cos(longitude)};
}

}  // namespace

void SkyOptions::validate() const {
  vo::require(sun_elevation >= 0 && sun_elevation <= pi / 2, "sky: the sun is ",
              sun_elevation * 180 / pi, " deg above the horizon, expected 0 to 90");
  vo::require(turbidity >= 1.8 && turbidity <= 10, "sky: a turbidity of ", turbidity,
              ", expected 1.8 to 10");
}

Environment clear_sky(const SkyOptions& options) {
  options.validate();
  constexpr double kPerKilo = 1000;
  const PreethamSky sky(options.turbidity, pi / 2 - options.sun_elevation);
  const Eigen::Vector3d sun(0, std::sin(options.sun_elevation), -std::cos(options.sun_elevation));
  Environment environment;
  environment.radiance.create(kRows, 2 * kRows);
  Eigen::Vector3d irradiance =
      std::sin(options.sun_elevation) * sunlight(options);  // of the ground
  for (int v = 0; v < kRows / 2; ++v) {
    for (int u = 0; u < 2 * kRows; ++u) {
      const Eigen::Vector3d direction = direction_of(v, u);
      const double from_sun = std::acos(std::clamp(direction.dot(sun), -1.0, 1.0));
      const Eigen::Vector3d light = rgb_of(sky.colour(direction.y(), from_sun));
      irradiance += vo::pixel_solid_angle(v, kRows) * direction.y() * light;
      const Eigen::Vector3d nits = kPerKilo * light;
      environment.radiance(v, u) = cv::Vec3d(nits.x(), nits.y(), nits.z());
    }
  }
  const Eigen::Vector3d ground = kPerKilo * kGroundAlbedo / pi * irradiance;
  environment.radiance.rowRange(kRows / 2, kRows) =
      cv::Vec3f(cv::Vec3d(ground.x(), ground.y(), ground.z()));
  const int row =
      std::clamp(static_cast<int>((0.5 - options.sun_elevation / pi) * kRows), 0, kRows / 2 - 1);
  const Eigen::Vector3d disc = kPerKilo / vo::pixel_solid_angle(row, kRows) * sunlight(options);
  environment.radiance(row, kRows) += cv::Vec3f(cv::Vec3d(disc.x(), disc.y(), disc.z()));
  return environment;
}

}  // namespace synth
