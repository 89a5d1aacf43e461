#include "tools/make_scenes/painting/picture_patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "tools/make_scenes/painting/noise.h"
#include "tools/make_scenes/painting/texture_painter.h"

namespace scenes {
namespace {

/// Returns 1 inside the rectangle around (x, y) with half sizes (a, b), else 0.
double inside_box(double x, double y, double a, double b) {
  return std::abs(x) < a && std::abs(y) < b ? 1 : 0;
}

/// Returns the colour of the rug's border at a distance `edge` from its edge, m.
Color rug_border(double edge, double along) {
  constexpr std::uint32_t kInk = 0x2b3350;
  if (edge < 0.03 || (edge > 0.19 && edge < 0.21)) {
    return rgb(kInk);
  }
  if (edge < 0.06 || edge > 0.16) {
    return rgb(0xc9ad7b);
  }
  const double motif = std::abs(fraction(along / 0.1) - 0.5) * 0.1 + std::abs(edge - 0.11);
  return motif < 0.025 ? rgb(0xd8c49a) : motif < 0.04 ? rgb(kInk) : rgb(0x7d2f2c);
}

Color rug_field(double x, double y) {
  const double medallion = std::abs(x) / 0.62 + std::abs(y) / 0.42;
  if (medallion < 1) {
    const double band = fraction(medallion * 4);
    return medallion < 0.2 ? rgb(0xd8c49a)
                           : mix(rgb(0x34406a), rgb(0xa9763f), band < 0.3 ? 1.0 : 0.0);
  }
  const double cell_x = std::abs(fraction(x / 0.16) - 0.5) * 0.16;
  const double cell_y = std::abs(fraction(y / 0.16) - 0.5) * 0.16;
  const double flower = cell_x + cell_y;
  return flower < 0.018 ? rgb(0xe0cfa6) : flower < 0.038 ? rgb(0x3d4a72) : rgb(0x8f3a33);
}

Color rug_color(double u, double v) {
  const double x = (u - 0.5) * 2.2;
  const double y = (v - 0.5) * 1.6;
  const double edge = std::min(1.1 - std::abs(x), 0.8 - std::abs(y));
  const double along = 1.1 - std::abs(x) < 0.8 - std::abs(y) ? y : x;
  const Color dye = edge < 0.21 ? rug_border(edge, along) : rug_field(x, y);
  const double weave =
      0.08 * random01(101, static_cast<int>(u * 512) / 2, static_cast<int>(v * 512));
  return dye * (0.82 + weave + 0.2 * fractal_noise(u, v, {6, 5, 102}, 2));
}

Color painting_color(double u, double v) {
  const double stroke = fractal_noise(u, v, {14, 50, 111}, 3);
  const double x = u + 0.02 * (stroke - 0.5);
  const double y = v + 0.03 * (fractal_noise(u, v, {30, 12, 112}, 2) - 0.5);
  const double cloud = fractal_noise(x, y, {4, 9, 113}, 4);
  Color color = mix(rgb(0x566a92), rgb(0xe6b183), y / 0.5);
  color = mix(color, rgb(0xf0d9c0), smooth_step(0.52, 0.66, cloud));
  color = mix(color, rgb(0xf6e3a6), smooth_step(0.06, 0.05, radius_of((x - 0.64) * 1.5, y - 0.4)));
  if (y > 0.52) {
    const double glitter = noise(x, y * y, {40, 90, 114});
    color = mix(rgb(0x3e5f7d), rgb(0xd9a981), glitter * smooth_step(0.35, 0.0, std::abs(x - 0.64)));
  }
  const double cliff = 0.62 - 0.5 * x + 0.2 * (fractal_noise(x, 0.5, {9, 2, 115}, 4) - 0.5);
  if (y > std::max(cliff, 0.35) && x < 0.45) {
    color = mix(rgb(0x3c3a33), rgb(0x8a7350), fractal_noise(x, y, {10, 14, 116}, 3));
  }
  const double shore = 0.86 - 0.08 * x + 0.05 * noise(x, 0.5, {7, 2, 117});
  if (y > shore) {
    color = mix(rgb(0x4d5a34), rgb(0xb7a35c), fractal_noise(x, y, {40, 20, 118}, 2));
  }
  return color * (0.88 + 0.24 * stroke);
}

Color map_color(double u, double v) {
  const double latitude = std::abs(v - 0.5) * 2;
  const double height = fractal_noise(u, v, {5, 3, 127}, 6) - 0.12 * latitude * latitude;
  const bool land = height > 0.5 || latitude > 0.93;
  const double relief = smooth_step(0.5, 0.68, height);
  const Color warm = mix(rgb(0xb9b57c), rgb(0x9a6f45), relief);
  Color color = mix(warm, rgb(0xe9e6de), smooth_step(0.72, 0.9, latitude));
  if (!land) {
    color = mix(rgb(0x5f8fa8), rgb(0xa9c9cf), smooth_step(0.32, 0.5, height));
  }
  if (std::abs(height - 0.5) < 0.006) {
    color = rgb(0x51503f);
  }
  const double meridian = std::abs(fraction(u * 12) - 0.5);
  const double parallel = std::abs(fraction(v * 6) - 0.5);
  return meridian > 0.488 || parallel > 0.488 ? mix(color, rgb(0x5b6670), 0.45) : color;
}

Color shapes_poster_color(double u, double v) {
  const double y = v * 1.4;
  Color color = rgb(0xe9e0cb) * (0.97 + 0.03 * noise(u, v, {32, 40, 131}));
  const double ring = radius_of(u - 0.62, y - 0.42);
  if (ring < 0.27) {
    color = ring < 0.1 ? rgb(0xe2b23f) : ring < 0.19 ? rgb(0x2d3f5e) : rgb(0xc0492f);
  }
  if (inside_box(u - y * 0.4 + 0.06, y - 0.55, 0.05, 0.42) > 0) {
    color = rgb(0x26262b);
  }
  if (u > 0.12 && y > 0.62 && u < 0.12 + 0.8 * (y - 0.62) && y < 1.0) {
    color = mix(rgb(0x3f7f86), color, 0.1);
  }
  if (inside_box(u - 0.68, y - 0.86, 0.2, 0.09) > 0) {
    color = fraction(u * 24) < 0.5 ? rgb(0x26262b) : rgb(0xc0492f);
  }
  const double title = print_ink((u - 0.1) / 0.8, (y - 1.08) / 0.14, {11, 1}, 132);
  const double small = print_ink((u - 0.1) / 0.6, (y - 1.25) / 0.08, {30, 2}, 133);
  return mix(color, rgb(0x26262b), std::max(title, small));
}

Color ridges_poster_color(double u, double v) {
  constexpr int kRidges = 6;
  Color color = mix(rgb(0xf0cfa0), rgb(0xd98f6c), v / 0.5);
  if (radius_of(u - 0.33, (v - 0.25) * 1.4) < 0.1) {
    color = rgb(0xf7efdc);
  }
  for (int ridge = 0; ridge < kRidges; ++ridge) {
    const double crest = fractal_noise(u, 0.37, {3 + ridge, 2, 141U + 7U * ridge}, 5);
    const double top = 0.3 + 0.1 * ridge + 0.26 * (0.5 - crest);
    if (v > top) {
      const Color rock = mix(rgb(0xb98a86), rgb(0x1f2f40), ridge / (kRidges - 1.0));
      const double mist = smooth_step(0.0, 0.14, v - top);
      const double trees = 0.12 * noise(u, v, {70, 40, 150U + ridge});
      color = mix(rock, rgb(0xd9b7a0), 0.35 * mist) * (0.94 + trees);
    }
  }
  const double title = print_ink((u - 0.15) / 0.7, (v - 0.86) / 0.07, {9, 1}, 148);
  return mix(color, rgb(0xf0e6d2), title);
}

/// Returns 1 on a bar from the dial's centre pointing `hour` (of 12) hours after noon, else 0.
double hand(const Eigen::Vector2d& p, double hour, double from, const Eigen::Vector2d& size) {
  const double angle = hour * std::numbers::pi / 6;
  const Eigen::Vector2d direction(std::sin(angle), -std::cos(angle));
  const double along = p.dot(direction);
  const double across = p.x() * direction.y() - p.y() * direction.x();
  return along > from && along < size.x() && std::abs(across) < size.y() ? 1 : 0;
}

Color clock_color(double u, double v) {
  const Eigen::Vector2d p(2 * u - 1, 2 * v - 1);
  double ink = 0;
  for (int minute = 0; minute < 60; ++minute) {
    const bool full = minute % 5 == 0;
    ink += hand(p, minute / 5.0, full ? 0.74 : 0.84, {0.92, full ? 0.028 : 0.01});
  }
  ink += hand(p, 10.0 + 8.0 / 60, -0.1, {0.5, 0.04}) + hand(p, 8.0 / 5, -0.14, {0.74, 0.028});
  const Color dial = rgb(0xece7da) * (1 - 0.08 * p.squaredNorm());
  const double second = hand(p, 34.0 / 5, -0.2, {0.82, 0.012});
  const Color color = mix(dial, rgb(0x26282c), ink);
  return mix(color, rgb(0xb23a2c), p.norm() < 0.06 ? 1.0 : second);
}

Color screen_color(double u, double v) {
  constexpr std::array<std::uint32_t, 5> kInks = {0xc8ccd2, 0x7fb0d8, 0xd99a6c, 0x93b87a, 0xb392c9};
  if (v < 0.06) {
    return mix(rgb(0x39404c), rgb(0xaeb6c2), print_ink((u - 0.02) / 0.4, v / 0.06, {30, 1}, 161));
  }
  if (u < 0.2) {
    const double names = print_ink((u - 0.02) / 0.16, (v - 0.08) / 0.8, {16, 22}, 162);
    return mix(rgb(0x252a33), rgb(0x8d97a5), names);
  }
  const int line = static_cast<int>((v - 0.06) / 0.94 * 30);
  const double indent = 0.24 + 0.03 * static_cast<int>(4 * random01(163, line));
  const double text = print_ink((u - indent) / 0.66, (v - 0.06) / 0.94, {66, 30}, 164);
  const int word = static_cast<int>((u - indent) * 14);
  const auto ink = static_cast<std::size_t>(5 * random01(165, line, word));
  return mix(line == 12 ? rgb(0x2d3543) : rgb(0x1c2028), rgb(kInks.at(ink)), text);
}

/// Returns the colour of a row of houses with windows in front of the sky.
Color houses(double u, double v, const Color& sky) {
  constexpr int kHouses = 13;
  const int house = static_cast<int>(u * kHouses);
  const double x = fraction(u * kHouses);
  const double gable = 0.04 * (1 - 2 * std::abs(x - 0.5));
  const double eaves = 0.44 + 0.07 * random01(171, house);
  if (v < eaves - gable || x < 0.04) {
    return sky;
  }
  const Color wall = mix(rgb(0xd9c3a0), rgb(0xa9705a), random01(172, house));
  if (v < eaves) {
    return rgb(0x7a4a3e) * (0.8 + 0.4 * random01(173, house));
  }
  const double pane_x = std::abs(fraction(x * 3) - 0.5);
  const double pane_y = std::abs(fraction((v - eaves) * 18) - 0.55);
  return pane_x < 0.24 && pane_y < 0.3 ? rgb(0x46525e) : wall;
}

Color view_color(double u, double v) {
  const double cloud = fractal_noise(u, v, {4, 8, 174}, 5);
  Color color = mix(rgb(0x86aed6), rgb(0xdde8ee), v / 0.55);
  color = mix(color, rgb(0xf7f7f4), smooth_step(0.5, 0.7, cloud));
  const double hill = 0.37 + 0.06 * fractal_noise(u, 0.5, {4, 2, 175}, 3);
  if (v > hill) {
    color = mix(rgb(0x7f9b86), rgb(0x9db59a), noise(u, v, {24, 40, 176}));
  }
  color = houses(u, v, color);
  const double crown = 0.54 + 0.1 * (0.5 - fractal_noise(u, 0.2, {14, 2, 177}, 3));
  if (v > crown) {
    color = mix(rgb(0x3b5b34), rgb(0x86a055), fractal_noise(u, v, {30, 30, 178}, 3));
  }
  return v > 0.74 ? mix(rgb(0x8f8d86), rgb(0xa7a49b), noise(u, v, {30, 60, 179})) : color;
}

double label_grey(double u, double v) {
  const double block = inside_box(u - 0.5, v - 0.33, 0.36, 0.17);
  const double disc = radius_of(u - 0.62, v - 0.34) < 0.13 ? 1 : 0;
  const double title = print_ink((u - 0.12) / 0.76, (v - 0.05) / 0.1, {9, 1}, 181);
  const double text = print_ink((u - 0.12) / 0.76, (v - 0.56) / 0.36, {28, 9}, 182);
  const double grey = 0.95 - 0.5 * block + 0.35 * disc * block;
  return grey * (1 - 0.85 * std::max(title, text));
}

double spine_grey(double u, double v) {
  const int spine = static_cast<int>(u * kBookSpines);
  const double x = fraction(u * kBookSpines);
  const double top = 0.06 + 0.12 * random01(191, spine);
  const double width = 0.008 + 0.03 * random01(192, spine);
  double grey = 0.9 - 0.12 * std::abs(2 * x - 1) + 0.08 * noise(u, v, {64, 24, 193});
  if (std::abs(v - top) < width || std::abs(v - 1 + top) < width) {
    grey *= random01(194, spine) < 0.5 ? 0.35 : 1.2;
  }
  const double begin = top + 0.08;
  const double length = 0.3 + 0.25 * random01(195, spine);
  const int letters = 8 + static_cast<int>(8 * random01(196, spine));
  const double title = print_ink((v - begin) / length, 1 - (x - 0.22) / 0.56, {letters, 1},
                                 197U + static_cast<std::uint32_t>(spine));
  return random01(198, spine) < 0.6 ? grey * (1 - 0.75 * title) : grey * 0.8 + 0.5 * title;
}

}  // namespace

cv::Mat rug_texture() {
  return paint(rug_color, {512, 512, 6});
}
cv::Mat painting_texture() {
  return paint(painting_color, {512, 512, 6});
}
cv::Mat map_texture() {
  return paint(map_color, {512, 256, 4});
}
cv::Mat shapes_poster_texture() {
  return paint(shapes_poster_color, {512, 512, 6});
}
cv::Mat ridges_poster_texture() {
  return paint(ridges_poster_color, {512, 512, 4});
}
cv::Mat clock_texture() {
  return paint(clock_color, {256, 256, 6});
}
cv::Mat screen_texture() {
  return paint(screen_color, {512, 256, 6});
}
cv::Mat view_texture() {
  return paint(view_color, {512, 256, 6});
}
cv::Mat label_texture() {
  return paint_grey(label_grey, {256, 256, 6});
}
cv::Mat book_spines_texture() {
  return paint_grey(spine_grey, {512, 256, 6});
}

}  // namespace scenes
