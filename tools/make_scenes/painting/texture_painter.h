#pragma once

#include <cstdint>
#include <functional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace scenes {

/// Red, green, blue in 0..1; sRGB-encoded in textures, linear in materials.
using Color = Eigen::Vector3d;

/// Returns the colour of an HTML code: rgb(0xRRGGBB).
Color rgb(std::uint32_t hex);

Color mix(const Color& a, const Color& b, double t);

/// A colour or grey level as a function of the texture coordinates, (0, 0) at the top left.
using Pattern = std::function<Color(double u, double v)>;
using GreyPattern = std::function<double(double u, double v)>;

struct Paper {
  int width = 512;   ///< texels, a power of two
  int height = 512;  ///< texels, a power of two
  int step = 4;      ///< step of the 8-bit values; keeps the PNG small
};

/// Returns the pattern as an image, CV_8UC3 in BGR order; a texel is the mean of 2x2 samples.
cv::Mat paint(const Pattern& pattern, const Paper& paper);

/// Returns the grey pattern as an image, CV_8UC1; a texel is the mean of 2x2 samples.
cv::Mat paint_grey(const GreyPattern& pattern, const Paper& paper);

/// Returns ink (0 or 1) that resembles lines of print: `columns` letters in `rows` lines on the
/// unit square, 0 outside it.
double print_ink(double u, double v, const Eigen::Vector2i& columns_rows, std::uint32_t seed);

}  // namespace scenes
