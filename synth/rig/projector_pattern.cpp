#include "synth/rig/projector_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "synth/shading/scrambled_sobol.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/random_field.h"
#include "vo/files/input.h"
#include "vo/image_files/png.h"

namespace synth {
namespace {

constexpr double kPixelsPerDiameter = 4;
constexpr std::uint64_t kDotPlaces = 0x9a76;  // purpose of the random numbers
constexpr double kRadPerDeg = std::numbers::pi / 180;

/// Calls a function and adds the projector to the message of its Error.
template <typename Function>
auto of_projector(const vo::RigProjector& projector, Function function) {
  try {
    return function();
  } catch (const vo::Error& error) {
    throw vo::Error(vo::concat(vo::describe(projector), ": pattern: ", error.what()), error.kind());
  }
}

/// Returns the mean of the channels of a PNG file's image, of which the greatest possible one is 1.
cv::Mat_<float> linear_grey(const cv::Mat& image) {
  const double white = image.type() == CV_16UC1 ? 65535.0 : 255.0 * image.channels();
  cv::Mat rows;
  image.reshape(1, image.rows * image.cols).convertTo(rows, CV_32F);
  cv::Mat sums;
  cv::reduce(rows, sums, 1, cv::REDUCE_SUM);
  cv::Mat_<float> grey;
  sums.reshape(1, image.rows).convertTo(grey, CV_32F, 1 / white);
  return grey;
}

cv::Mat_<float> read_pattern(const vo::RigProjector& projector) {
  constexpr std::size_t kMostPixels = std::size_t{1} << 24U;
  const std::string bytes = pattern_bytes(projector);
  const cv::Mat image =
      of_projector(projector, [&] { return vo::decode_png(bytes, projector.file()); });
  vo::require(image.total() <= kMostPixels, vo::describe(projector),
              ": pattern: ", projector.file().string(), ": is ", image.cols, " x ", image.rows,
              " px, expected at most ", kMostPixels, " pixels");
  return linear_grey(image);
}

/// Returns the size of the picture of random dots whose diameter is `diameter` on a plane at
/// distance 1.
cv::Size size_of_dots(const vo::RigProjector& projector, double diameter) {
  constexpr double kMaxSide = 4096;  // px
  const Eigen::Vector2d half = half_extent_of(projector);
  const Eigen::Vector2d size = 2 * half * kPixelsPerDiameter / diameter;
  const double least = 2 * half.maxCoeff() * kPixelsPerDiameter / kMaxSide;
  vo::require(size.maxCoeff() <= kMaxSide, vo::describe(projector),
              ": dots.diameter_deg: expected at least ",
              std::ceil(1e4 * 2 * std::atan(least / 2) / kRadPerDeg) / 1e4,
              " deg in this field of view, got ", projector.dots.diameter_deg);
  return {static_cast<int>(std::ceil(size.x())), static_cast<int>(std::ceil(size.y()))};
}

/// Brightens the pixels of a dot. `centre` is in px, `pixel` the size of a pixel in diameters.
void draw_dot(const Eigen::Vector2d& centre, const Eigen::Vector2d& pixel,
              cv::Mat_<float>& pattern) {
  const Eigen::Vector2d reach = pixel.cwiseInverse();
  const Eigen::Vector2i first = (centre - reach).array().ceil().matrix().cast<int>().cwiseMax(0);
  const Eigen::Vector2i last = (centre + reach)
                                   .array()
                                   .floor()
                                   .matrix()
                                   .cast<int>()
                                   .cwiseMin(Eigen::Vector2i(pattern.cols - 1, pattern.rows - 1));
  for (int v = first.y(); v <= last.y(); ++v) {
    for (int u = first.x(); u <= last.x(); ++u) {
      const double r = (Eigen::Vector2d(u, v) - centre).cwiseProduct(pixel).norm();
      const double wave = r < 1 ? std::cos(r * std::numbers::pi / 2) : 0;
      pattern(v, u) = std::max(pattern(v, u), static_cast<float>(wave * wave));
    }
  }
}

cv::Mat_<float> draw_random_dots(const vo::RigProjector& projector) {
  const double diameter = 2 * std::tan(projector.dots.diameter_deg * kRadPerDeg / 2);
  const cv::Size size = size_of_dots(projector, diameter);
  const Eigen::Vector2d pixel =
      2 * half_extent_of(projector).cwiseQuotient(Eigen::Vector2d(size.width, size.height)) /
      diameter;
  cv::Mat_<float> pattern(size, 0.0F);
  const std::uint64_t bits = vo::RandomField(projector.dots.seed, kDotPlaces, 0).bits(0, 0);
  for (int i = 0; i < projector.dots.number; ++i) {
    const Eigen::Vector2d place = scrambled_sobol(bits, i).cast<double>();
    draw_dot({size.width * place.x() - 0.5, size.height * place.y() - 0.5}, pixel, pattern);
  }
  return pattern;
}

}  // namespace

Eigen::Vector2d half_extent_of(const vo::RigProjector& projector) {
  return (projector.fov_deg * kRadPerDeg / 2).array().tan();
}

std::string pattern_bytes(const vo::RigProjector& projector) {
  return of_projector(projector,
                      [&] { return vo::read_file(projector.file(), vo::kMaxDocumentBytes); });
}

cv::Mat_<float> pattern_of(const vo::RigProjector& projector) {
  return projector.has_file() ? read_pattern(projector) : draw_random_dots(projector);
}

}  // namespace synth
