#include "tools/make_scenes/painting/texture_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/make_scenes/painting/noise.h"

namespace scenes {
namespace {

std::uint8_t quantize(double value, int step) {
  const int level = static_cast<int>(std::floor(value * 255 / step + 0.5)) * step;
  return static_cast<std::uint8_t>(std::clamp(level, 0, 255));
}

Color mean_of_samples(const Pattern& pattern, int x, int y, const Paper& paper) {
  Color sum = Color::Zero();
  for (const double dy : {0.25, 0.75}) {
    for (const double dx : {0.25, 0.75}) {
      sum += pattern((x + dx) / paper.width, (y + dy) / paper.height);
    }
  }
  return sum / 4;
}

}  // namespace

Color rgb(std::uint32_t hex) {
  return Color((hex >> 16U) & 255U, (hex >> 8U) & 255U, hex & 255U) / 255.0;
}

Color mix(const Color& a, const Color& b, double t) {
  return a + (b - a) * std::clamp(t, 0.0, 1.0);
}

cv::Mat paint(const Pattern& pattern, const Paper& paper) {
  cv::Mat_<cv::Vec3b> image(paper.height, paper.width);
  for (int y = 0; y < paper.height; ++y) {
    for (int x = 0; x < paper.width; ++x) {
      const Color color = mean_of_samples(pattern, x, y, paper);
      image(y, x) = {quantize(color.z(), paper.step), quantize(color.y(), paper.step),
                     quantize(color.x(), paper.step)};
    }
  }
  return image;
}

cv::Mat paint_grey(const GreyPattern& pattern, const Paper& paper) {
  const Pattern colored = [&](double u, double v) -> Color {
    return Color::Constant(pattern(u, v));
  };
  cv::Mat_<std::uint8_t> image(paper.height, paper.width);
  for (int y = 0; y < paper.height; ++y) {
    for (int x = 0; x < paper.width; ++x) {
      image(y, x) = quantize(mean_of_samples(colored, x, y, paper).x(), paper.step);
    }
  }
  return image;
}

double print_ink(double u, double v, const Eigen::Vector2i& columns_rows, std::uint32_t seed) {
  if (u < 0 || u >= 1 || v < 0 || v >= 1) {
    return 0;
  }
  const double x = u * columns_rows.x();
  const double y = v * columns_rows.y();
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double line_end = columns_rows.x() * (0.6 + 0.4 * random01(seed + 1, row));
  const bool space = random01(seed + 2, column, row) < 0.17 || column > line_end;
  const double letter_x = fraction(x) * 4;
  const double letter_y = fraction(y) * 8 - 1;
  if (space || letter_x >= 3 || letter_y < 0 || letter_y >= 5) {
    return 0;
  }
  const int stroke = static_cast<int>(letter_y) * 3 + static_cast<int>(letter_x);
  const int letter = static_cast<int>(26 * random01(seed, column, row));
  return random01(seed + 3, letter, stroke) < 0.6 ? 1 : 0;
}

}  // namespace scenes
