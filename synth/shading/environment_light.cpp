#include "synth/shading/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "vo/geometry/equirectangular.h"

namespace synth {
namespace {

using std::numbers::pi_v;

Eigen::Vector3f at_pixel(const cv::Mat_<cv::Vec3f>& image, int v, int u) {
  const int row = std::clamp(v, 0, image.rows - 1);
  const int column = (u % image.cols + image.cols) % image.cols;
  const cv::Vec3f& pixel = image(row, column);
  return {pixel[0], pixel[1], pixel[2]};
}

/// Returns where a unit direction in the environment's axes lies in its image, px from the corner.
Eigen::Vector2f place_of(const cv::Mat_<cv::Vec3f>& image, const Eigen::Vector3f& direction) {
  const float longitude = std::atan2(direction.x(), -direction.z());
  const float colatitude = std::acos(std::clamp(direction.y(), -1.0F, 1.0F));
  return {(0.5F + longitude / (2 * pi_v<float>)) * static_cast<float>(image.cols),
          colatitude / pi_v<float> * static_cast<float>(image.rows)};
}

/// Returns the pixel that holds a place.
cv::Point pixel_of(const cv::Mat_<cv::Vec3f>& image, const Eigen::Vector2f& place) {
  return {std::clamp(static_cast<int>(place.x()), 0, image.cols - 1),
          std::clamp(static_cast<int>(place.y()), 0, image.rows - 1)};
}

/// Returns the unit direction of a longitude, rad clockwise from -z, and a height above the
/// horizon, the cosine of the angle from straight up.
Eigen::Vector3f direction_of(float longitude, float height) {
  const float level = std::sqrt(std::max(0.0F, 1 - height * height));
  return {level * std::sin(longitude), height, -level * std::cos(longitude)};
}

/// Returns the cosine of the angle from straight up at the upper edge of a row.
float height_of_edge(int row, int rows) {
  return std::cos(pi_v<float> * static_cast<float>(row) / static_cast<float>(rows));
}

/// Returns the mean over a pixel of its brightest channel, where radiance is interpolated between
/// neighbours: three quarters of it is the pixel's own along each axis, an eighth each neighbour's.
float mean_brightness(const cv::Mat_<cv::Vec3f>& image, int v, int u) {
  constexpr std::array<float, 3> kShares = {0.125F, 0.75F, 0.125F};
  float sum = 0;
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    for (std::size_t k = 0; k < kShares.size(); ++k) {
      const Eigen::Vector3f light =
          at_pixel(image, v + static_cast<int>(i) - 1, u + static_cast<int>(k) - 1);
      sum += kShares.at(i) * kShares.at(k) * light.maxCoeff();
    }
  }
  return sum;
}

/// Returns the index of the first sum above a random number's share of the last one, 1, and moves
/// `random` to where it lies between the sums, 0 to 1.
std::size_t chosen_of(const float* sums, std::size_t count, float& random) {
  const float* const found = std::upper_bound(sums, sums + count - 1, random);
  const auto index = static_cast<std::size_t>(found - sums);
  const float before = index == 0 ? 0 : sums[index - 1];
  random = sums[index] > before ? (random - before) / (sums[index] - before) : 0.5F;
  return index;
}

float step_of(const float* sums, std::size_t index) {
  return sums[index] - (index == 0 ? 0 : sums[index - 1]);
}

/// Makes sums of weights end at 1; of zeros, equal steps. Returns the sum of the weights.
double normalise(float* sums, const std::vector<double>& weights) {
  double total = 0;
  for (const double weight : weights) {
    total += weight;
  }
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += total > 0 ? weights[i] / total : 1.0 / static_cast<double>(weights.size());
    sums[i] = static_cast<float>(sum);
  }
  sums[weights.size() - 1] = 1;
  return total;
}

/// Returns the values of the harmonics of bands 0 to 2 in a unit direction.
std::array<float, 9> harmonics(const Eigen::Vector3f& d) {
  return {0.282095F,
          0.488603F * d.y(),
          0.488603F * d.z(),
          0.488603F * d.x(),
          1.092548F * d.x() * d.y(),
          1.092548F * d.y() * d.z(),
          0.315392F * (3 * d.z() * d.z() - 1),
          1.092548F * d.x() * d.z(),
          0.546274F * (d.x() * d.x() - d.y() * d.y())};
}

/// Returns the rotation that turns the environment's image about the world's vertical.
Eigen::Matrix3f R_world_environment(const Environment& environment) {
  return Eigen::AngleAxisf(static_cast<float>(environment.turn), Eigen::Vector3f::UnitY())
      .toRotationMatrix();
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment)
    : environment_(environment), R_world_environment_(R_world_environment(environment)) {}

Eigen::Vector3f EnvironmentLight::radiance(const Eigen::Vector3f& direction) const {
  const cv::Mat_<cv::Vec3f>& image = environment_.radiance;
  const Eigen::Vector2f place =
      place_of(image, in_image_axes(direction)) - Eigen::Vector2f(0.5F, 0.5F);
  const auto u = static_cast<int>(std::floor(place.x()));
  const auto v = static_cast<int>(std::floor(place.y()));
  const float right = place.x() - static_cast<float>(u);
  const float below = place.y() - static_cast<float>(v);
  const auto row = [&](int at) {
    return Eigen::Vector3f((1 - right) * at_pixel(image, at, u) +
                           right * at_pixel(image, at, u + 1));
  };
  return (1 - below) * row(v) + below * row(v + 1);
}

EnvironmentDirections::EnvironmentDirections(const EnvironmentLight& light) : light_(light) {
  const cv::Mat_<cv::Vec3f>& image = light.image();
  rows_.resize(static_cast<std::size_t>(image.rows));
  columns_.resize(image.total());
  std::vector<double> of_rows(rows_.size());
  std::vector<double> of_columns(static_cast<std::size_t>(image.cols));
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      of_columns[static_cast<std::size_t>(u)] = mean_brightness(image, v, u);
    }
    of_rows[static_cast<std::size_t>(v)] =
        normalise(&columns_[column_begin(v)], of_columns) * vo::pixel_solid_angle(v, image.rows);
  }
  normalise(rows_.data(), of_rows);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const double solid_angle = vo::pixel_solid_angle(static_cast<int>(row), image.rows);
    per_sr_.push_back(static_cast<float>(step_of(rows_.data(), row) / solid_angle));
  }
}

std::size_t EnvironmentDirections::column_begin(int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(light_.image().cols);
}

DrawnLight EnvironmentDirections::draw(const Eigen::Vector2f& square) const {
  const cv::Mat_<cv::Vec3f>& image = light_.image();
  float across = square.x();
  float down = square.y();
  const auto row = static_cast<int>(chosen_of(rows_.data(), rows_.size(), down));
  const std::size_t column =
      chosen_of(&columns_[column_begin(row)], static_cast<std::size_t>(image.cols), across);
  const float longitude =
      2 * pi_v<float> *
      ((static_cast<float>(column) + across) / static_cast<float>(image.cols) - 0.5F);
  const float upper = height_of_edge(row, image.rows);
  const float height = upper + down * (height_of_edge(row + 1, image.rows) - upper);
  DrawnLight light;
  light.to_light = light_.in_world_axes(direction_of(longitude, height));
  light.radiance = light_.radiance(light.to_light);
  light.density = density(light.to_light);
  return light;
}

float EnvironmentDirections::density(const Eigen::Vector3f& direction) const {
  const cv::Mat_<cv::Vec3f>& image = light_.image();
  const cv::Point pixel = pixel_of(image, place_of(image, light_.in_image_axes(direction)));
  return per_sr_[static_cast<std::size_t>(pixel.y)] *
         step_of(&columns_[column_begin(pixel.y)], static_cast<std::size_t>(pixel.x));
}

EnvironmentIrradiance::EnvironmentIrradiance(const Environment& environment) {
  const cv::Mat_<cv::Vec3f>& image = environment.radiance;
  const Eigen::Matrix3f R = R_world_environment(environment);
  std::array<Eigen::Vector3d, 9> sums;
  sums.fill(Eigen::Vector3d::Zero());
  for (int v = 0; v < image.rows; ++v) {
    const float upper = height_of_edge(v, image.rows);
    const float lower = height_of_edge(v + 1, image.rows);
    const auto solid_angle = static_cast<float>(vo::pixel_solid_angle(v, image.rows));
    for (int u = 0; u < image.cols; ++u) {
      const float longitude =
          2 * pi_v<float> *
          ((static_cast<float>(u) + 0.5F) / static_cast<float>(image.cols) - 0.5F);
      const std::array<float, 9> values =
          harmonics(R * direction_of(longitude, 0.5F * (upper + lower)));
      const Eigen::Vector3d light = (solid_angle * at_pixel(image, v, u)).cast<double>();
      for (std::size_t i = 0; i < values.size(); ++i) {
        sums[i] += values[i] * light;
      }
    }
  }
  // A surface's cosine weakens each band by its own factor.
  constexpr std::array<double, 3> kCosine = {std::numbers::pi, 2 * std::numbers::pi / 3,
                                             std::numbers::pi / 4};
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const std::size_t band = i == 0 ? 0 : (i < 4 ? 1 : 2);
    coefficients_[i] = (kCosine[band] * sums[i]).cast<float>();
  }
}

Eigen::Vector3f EnvironmentIrradiance::operator()(const Eigen::Vector3f& normal) const {
  const std::array<float, 9> values = harmonics(normal);
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i] * coefficients_[i];
  }
  return sum.cwiseMax(0.0F);
}

}  // namespace synth
