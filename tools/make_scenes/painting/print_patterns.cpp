#include "tools/make_scenes/painting/print_patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "tools/make_scenes/painting/noise.h"
#include "tools/make_scenes/painting/texture_painter.h"

namespace scenes {
namespace {

/// The nearest of the scattered points, and how much farther the second nearest is.
struct Cell {
  int column = 0;
  int row = 0;
  double margin = 0;  ///< difference of squared distances, lattice units squared
};

/// Returns the nearest of the random points, one in each lattice cell; x and y in lattice units.
Cell nearest_point(double x, double y, std::uint32_t seed) {
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  Cell nearest;
  double best = 1e9;
  double second = 1e9;
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      const double dx = i + random01(seed, i, j) - x;
      const double dy = j + random01(seed + 1, i, j) - y;
      const double distance = dx * dx + dy * dy;
      if (distance < best) {
        second = best;
        best = distance;
        nearest = {i, j, 0};
      } else {
        second = std::min(second, distance);
      }
    }
  }
  nearest.margin = second - best;
  return nearest;
}

using Palette = std::array<std::uint32_t, 8>;

constexpr Palette kWarm = {0x2f3b4c, 0xe8dfc8, 0xb5523b, 0x6d8f8a,
                           0xd9a441, 0x8c8577, 0x4c6a45, 0xc7b7a3};
constexpr Palette kCold = {0x1e2a38, 0xdfe8ea, 0x3c6e91, 0xa54a6a,
                           0xe0c068, 0x5d6b7a, 0x86b29a, 0xb9a4c8};

Color palette_color(const Palette& palette, std::uint32_t seed, int i, int j) {
  return rgb(palette.at(static_cast<std::size_t>(8 * random01(seed, i, j))));
}

/// Returns the colour of a mosaic of large cells, a third of them split into small ones, and dots.
/// x and y are in large cells.
Color mosaic_color(double x, double y, const Palette& palette, std::uint32_t seed) {
  const Cell large = nearest_point(x, y, seed);
  Color color = palette_color(palette, seed + 2, large.column, large.row);
  if (random01(seed + 3, large.column, large.row) < 0.4) {
    const Cell small = nearest_point(4 * x, 4 * y, seed + 4);
    color = palette_color(palette, seed + 6, small.column, small.row);
  }
  const int column = static_cast<int>(std::floor(3 * x));
  const int row = static_cast<int>(std::floor(3 * y));
  const double dot_x = 3 * x - column - 0.3 - 0.4 * random01(seed + 7, column, row);
  const double dot_y = 3 * y - row - 0.3 - 0.4 * random01(seed + 8, column, row);
  const double radius = 0.06 + 0.16 * random01(seed + 9, column, row);
  if (dot_x * dot_x + dot_y * dot_y < radius * radius) {
    color = palette_color(palette, seed + 10, column, row);
  }
  return large.margin < 0.02 ? rgb(0x201f1e) : color;
}

Color linoleum_color(double u, double v) {
  const bool dark = (static_cast<int>(u * 4) + static_cast<int>(v * 4)) % 2 == 0;
  const double x = fraction(u * 4);
  const double y = fraction(v * 4);
  const double joint = std::min({x, 1 - x, y, 1 - y});
  const double fleck = fractal_noise(u, v, {32, 32, 401}, 3);
  const double marbling = fractal_noise(u, v, {12, 12, 405}, 4);
  const Color ground = dark ? rgb(0x5a6a68) : rgb(0xb8b5a4);
  const Color tile = ground * (0.82 + 0.25 * fleck + 0.14 * smooth_step(0.5, 0.62, marbling));
  return tile * (0.55 + 0.45 * smooth_step(0.004, 0.014, joint));
}

double ceiling_panel_grey(double u, double v) {
  const double joint = std::min({u, 1 - u, v, 1 - v});
  const int column = static_cast<int>(u * 28);
  const int row = static_cast<int>(v * 28);
  const double x = fraction(u * 28) - 0.5 - 0.3 * (random01(411, column, row) - 0.5);
  const double y = fraction(v * 28) - 0.5 - 0.3 * (random01(412, column, row) - 0.5);
  const double radius = 0.3 * random01(413, column, row);
  const double hole = x * x + y * y < radius * radius ? 0.25 : 0;
  return (0.92 - hole) * (joint < 0.012 ? 0.62 : 1);
}

/// Returns the colour of an exit sign: four letters and an arrow in a frame.
Color exit_sign_color(double u, double v) {
  const Color green = rgb(0x12814a);
  Color white = rgb(0xf2f6ee);
  if (std::min({u, (1 - u), v / 2, (1 - v) / 2}) < 0.02) {
    return white;
  }
  const double letters = print_ink((u - 0.1) / 0.42, (v - 0.24) / 0.6, {4, 1}, 421);
  const double shaft = u > 0.6 && u < 0.76 && std::abs(v - 0.5) < 0.09 ? 1 : 0;
  const double head = u >= 0.76 && std::abs(v - 0.5) < 2 * (0.9 - u) ? 1 : 0;
  return mix(green, white, std::max({letters, shaft, head}));
}

/// Returns 1 (ink) or 0 of a framed bar chart on the unit square.
double chart_ink(double x, double y) {
  if (x < 0 || x > 1 || y < 0 || y > 1) {
    return 0;
  }
  if (x < 0.012 || y > 0.98) {
    return 1;
  }
  const int bar = static_cast<int>(x * 12);
  const bool inside = fraction(x * 12) > 0.25 && 1 - y < 0.15 + 0.8 * random01(431, bar);
  return inside ? (bar % 3 == 0 ? 0.9 : 0.45) : 0;
}

double page_grey(double u, double v) {
  const double title = print_ink((u - 0.12) / 0.76, (v - 0.06) / 0.035, {26, 1}, 432);
  const double left = print_ink((u - 0.1) / 0.38, (v - 0.13) / 0.8, {34, 46}, 433);
  const double upper = print_ink((u - 0.53) / 0.38, (v - 0.13) / 0.3, {34, 17}, 434);
  const double lower = print_ink((u - 0.53) / 0.38, (v - 0.7) / 0.23, {34, 13}, 435);
  const double chart = chart_ink((u - 0.54) / 0.36, (v - 0.46) / 0.2);
  const double ink = std::max({title, left, upper, lower, chart});
  return 0.95 - 0.85 * ink;
}

Color handwriting_color(double u, double v) {
  constexpr int kLines = 22;
  const double squares =
      std::max(wave(u * 42 + 0.5) > 0.97 ? 1.0 : 0.0, wave(v * 59.4 + 0.5) > 0.97 ? 1.0 : 0.0);
  const Color paper = mix(rgb(0xf1efe4), rgb(0xa9bfd0), 0.7 * squares);
  const int line = static_cast<int>(v * kLines);
  const double y = fraction(v * kLines) - 0.5;
  const bool written = line > 1 && line < 19 && u > 0.1 && u < 0.6 + 0.32 * random01(441, line) &&
                       random01(442, line, static_cast<int>(u * 17)) > 0.16;
  const double pen = 0.3 * (noise(u, 0.5, {90, 2, 443U + static_cast<std::uint32_t>(line)}) - 0.5) +
                     0.22 * (wave(u * 60 + 3 * noise(u, 0.5, {12, 2, 470})) - 0.5);
  const double ink = written ? smooth_step(0.11, 0.05, std::abs(y - pen)) : 0;
  return mix(paper, rgb(0x2a3f7a), ink);
}

Color cork_color(double u, double v) {
  const Cell crumb = nearest_point(u * 60, v * 60, 451);
  const double tone = random01(453, crumb.column % 60, crumb.row % 60);
  const double wear = fractal_noise(u, v, {5, 5, 454}, 3);
  return mix(rgb(0x7a5230), rgb(0xc79a63), 0.2 + 0.5 * tone + 0.3 * wear);
}

/// Returns the grey of a ruler of 320 mm whose long marks carry a blot for their number.
double ruler_grey(double u, double v) {
  const double mm = u * 320;
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): mm is at or above 0
  const int tick = static_cast<int>(mm + 0.5);
  const double length = tick % 10 == 0 ? 0.5 : tick % 5 == 0 ? 0.38 : 0.25;
  const bool on_tick = std::abs(mm - tick) < 0.16 && v < length;
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): u is at or above 0
  const auto centimetre = static_cast<std::uint32_t>(u * 32 + 0.5);
  const double number =
      print_ink(fraction(u * 32 + 0.5) * 2 - 0.5, (v - 0.58) / 0.28, {2, 1}, 461U + centimetre);
  return on_tick || number > 0 ? 0.08 : 0.82;
}

Color checker_color(double u, double v) {
  const double x = (u - 0.06) / 0.88 * 8;
  const double y = (v - 0.06) / 0.88 * 8;
  const double grain = fractal_noise(u, v, {4, 40, 471}, 3);
  if (x < 0 || x >= 8 || y < 0 || y >= 8) {
    return rgb(0x5b3a22) * (0.7 + 0.5 * grain);
  }
  const bool dark = (static_cast<int>(x) + static_cast<int>(y)) % 2 == 1;
  return (dark ? rgb(0x4a2c1a) : rgb(0xdfc193)) * (0.8 + 0.3 * grain);
}

Color crate_color(double u, double v) {
  const bool frame = std::min({u, 1 - u, v, 1 - v}) < 0.13;
  const bool side = std::min(u, 1 - u) < 0.13;
  const double across = side ? u : v;
  const double along = side ? v : u;
  const int board = frame ? 20 : static_cast<int>(v * 5);
  const double grain = noise(along, across, {6, 90, 481U + static_cast<std::uint32_t>(board)});
  const double rings = wave(9 * across + 2 * fractal_noise(along, across, {3, 5, 483}, 2));
  Color color = mix(rgb(0x8a6238), rgb(0xd3a76a), 0.3 + 0.4 * grain + 0.25 * rings);
  const double joint = frame ? 1 : std::min(fraction(v * 5), 1 - fraction(v * 5));
  color *= 0.5 + 0.5 * smooth_step(0.01, 0.05, joint);
  const double stencil = print_ink((u - 0.24) / 0.52, (v - 0.34) / 0.3, {6, 2}, 485);
  color = mix(color, rgb(0x241d18), 0.85 * stencil);
  const double nail_x = std::min(u, 1 - u) - 0.06;
  const double nail_y = fraction(v * 5) - 0.5;
  return nail_x * nail_x + nail_y * nail_y / 25 < 0.00012 ? rgb(0x4b4f55) : color;
}

Color ball_color(double u, double v) {
  constexpr int kPanels = 8;
  const int panel = static_cast<int>(fraction(u) * kPanels);
  const bool belt = std::abs(v - 0.5) < 0.07;
  const Color ground = panel % 2 == 0   ? rgb(0xf0ece0)
                       : panel % 4 == 1 ? rgb(0xc23b2e)
                                        : rgb(0x2c5fa3);
  const double star = std::abs(fraction(u * kPanels) - 0.5) / 0.3 + std::abs(v - 0.28) / 0.1;
  const Color marked = star < 1 ? rgb(0xe5b832) : ground;
  return belt ? (fraction(u * 3 * kPanels) < 0.5 ? rgb(0x22252b) : rgb(0xe5b832)) : marked;
}

}  // namespace

cv::Mat mosaic_texture() {
  return paint([](double u, double v) { return mosaic_color(24 * u, 12 * v, kWarm, 501); },
               {2048, 1024, 8});
}
cv::Mat mosaic_box_texture() {
  return paint([](double u, double v) { return mosaic_color(6 * u, 6 * v, kCold, 521); },
               {512, 512, 8});
}
cv::Mat linoleum_texture() {
  return paint(linoleum_color, {512, 512, 6});
}
cv::Mat ceiling_panels_texture() {
  return paint_grey(ceiling_panel_grey, {256, 256, 6});
}
cv::Mat exit_sign_texture() {
  return paint(exit_sign_color, {256, 128, 6});
}
cv::Mat page_texture() {
  return paint_grey(page_grey, {1024, 1024, 8});
}
cv::Mat handwriting_texture() {
  return paint(handwriting_color, {512, 1024, 8});
}
cv::Mat cork_texture() {
  return paint(cork_color, {256, 256, 6});
}
cv::Mat ruler_texture() {
  return paint_grey(ruler_grey, {2048, 128, 8});
}
cv::Mat checker_texture() {
  return paint(checker_color, {256, 256, 6});
}
cv::Mat crate_texture() {
  return paint(crate_color, {512, 512, 6});
}
cv::Mat ball_texture() {
  return paint(ball_color, {512, 256, 6});
}

}  // namespace scenes
