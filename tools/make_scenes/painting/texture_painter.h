#pragma once

#include <cstdint>
#include <functional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace scenes {

/// Red, green, blue in 0..1; sRGB-encoded in textures, linear in materials.
using Color = Eigen::Vector3d;

/// The colour written as in HTML: rgb(0xRRGGBB).
Color rgb(std::uint32_t hex);

Color mix(const Color& a, const Color& b, double t);

/// Colour (or grey level) as a function of the texture coordinates, (0, 0) at the top left.
using Pattern = std::function<Color(double u, double v)>;
using GreyPattern = std::function<double(double u, double v)>;

struct Paper {
  int width = 512;   ///< texels, a power of two
  int height = 512;  ///< texels, a power of two
  int step = 4;      ///< 8-bit values are multiples of it, so that the PNG stays small
};

/// The pattern as an image, CV_8UC3 in BGR order; a texel is the mean of 2x2 samples.
cv::Mat paint(const Pattern& pattern, const Paper& paper);

/// The same for a grey pattern, CV_8UC1.
cv::Mat paint_grey(const GreyPattern& pattern, const Paper& paper);

/// Ink (0 or 1) of something that looks like lines of print: `columns` letters in `rows` lines on
/// the unit square, 0 outside it.
double print_ink(double u, double v, const Eigen::Vector2i& columns_rows, std::uint32_t seed);

}  // namespace scenes
