#include "tools/make_scenes/painting/surface_patterns.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tools/make_scenes/painting/noise.h"
#include "tools/make_scenes/painting/texture_painter.h"

namespace scenes {
namespace {

/// Returns the brightness in 0..1 of wood at x along and y across the grain, m.
double wood_grain(double x, double y, std::uint32_t seed) {
  const double u = x / 4;
  const double v = y / 4;
  const double bend = fractal_noise(u, v, {6, 24, seed}, 2);
  const double rings = wave(y * 22 + 5 * bend);
  const double streaks = noise(u, v, {24, 700, seed + 5});
  const double fibres = noise(u, v, {110, 1500, seed + 9});
  return 0.3 * rings + 0.4 * streaks + 0.3 * fibres;
}

Color plank_color(double u, double v) {
  constexpr int kRows = 10;
  const int row = static_cast<int>(v * kRows);
  const double along = fraction(u + random01(11, row)) * 2;
  const int plank = 2 * row + static_cast<int>(along);
  const double x = fraction(along) * 1.2;
  const double y = fraction(v * kRows) * 0.16;
  const double tone = random01(12, plank);
  const double grain = wood_grain(x, y, 100U + static_cast<std::uint32_t>(plank));
  const Color dark = mix(rgb(0x6b4a2f), rgb(0x6e5640), random01(13, plank));
  const Color light = mix(rgb(0xc49a68), rgb(0xb99a76), random01(14, plank));
  const double gap = std::min({x, 1.2 - x, y, 0.16 - y});
  const double shade = 0.45 + 0.55 * smooth_step(0.0006, 0.003, gap);
  return mix(dark, light, 0.05 + 0.4 * tone + 0.5 * grain) * shade;
}

Color brick_color(double u, double v) {
  constexpr int kColumns = 10;
  constexpr int kRows = 10;
  const double ragged = 0.003 * (fractal_noise(u, v, {80, 24, 21}, 2) - 0.5);
  const int row = static_cast<int>(v * kRows);
  const double along = fraction(u + (row % 2) * 0.5 / kColumns) * kColumns;
  const int brick = row * kColumns + static_cast<int>(along);
  const double x = fraction(along) * 0.25;
  const double y = fraction(v * kRows) * 0.075;
  const double inside = std::min({x, 0.25 - x, y, 0.075 - y}) - 0.005 + ragged;
  const double speckle = fractal_noise(u, v, {96, 28, 22}, 2);
  const Color clay = mix(mix(rgb(0x8a4a38), rgb(0xa9644a), random01(23, brick)), rgb(0xb98a6c),
                         0.5 * random01(24, brick));
  const Color face = clay * (0.78 + 0.3 * speckle + 0.08 * random01(25, brick));
  const Color mortar = rgb(0xb4aa9c) * (0.8 + 0.25 * speckle);
  const double rim = 0.8 + 0.2 * smooth_step(0.0, 0.006, inside);
  return mix(mortar, face * rim, smooth_step(-0.0015, 0.0015, inside));
}

Color wallpaper_color(double u, double v) {
  const double x = std::abs(fraction(u * 2 + 0.5 * (static_cast<int>(v * 4) % 2)) - 0.5);
  const double y = std::abs(fraction(v * 4) - 0.5);
  const double diamond = x + y;
  const double motif = smooth_step(0.34, 0.3, diamond) * smooth_step(0.2, 0.24, diamond) +
                       smooth_step(0.1, 0.07, radius_of(x, y));
  const double stripe = wave(u * 8);
  const double paper = fractal_noise(u, v, {6, 6, 31}, 3);
  const Color ground = mix(rgb(0x8d9f92), rgb(0x96a89a), stripe) * (0.94 + 0.1 * paper);
  return mix(ground, rgb(0xb9c2ae), 0.7 * motif);
}

double wood_grey(double u, double v) {
  const double bend = fractal_noise(u, v, {2, 4, 41}, 3);
  const double rings = wave(v * 7 + 3 * bend);
  const double streaks = noise(u, v, {5, 70, 42});
  const double fibres = noise(u, v, {24, 128, 43});
  return 0.66 + 0.12 * rings + 0.13 * streaks + 0.08 * fibres;
}

double fabric_grey(double u, double v) {
  constexpr int kThreads = 32;
  const int column = static_cast<int>(u * kThreads);
  const int row = static_cast<int>(v * kThreads);
  const bool warp = (column + row) % 2 == 0;
  const double across = warp ? fraction(u * kThreads) : fraction(v * kThreads);
  const double thread = warp ? random01(51, column) : random01(52, row);
  const double wear = fractal_noise(u, v, {3, 3, 53}, 3);
  return 0.66 + 0.16 * wave(across) + 0.08 * thread + 0.1 * wear;
}

double carpet_grey(double u, double v) {
  const double loops = wave(u * 16) * wave(v * 16 + 0.5 * (static_cast<int>(u * 16) % 2));
  return 0.45 + 0.35 * loops + 0.2 * noise(u, v, {32, 32, 61});
}

double marble_grey(double u, double v) {
  const double bend = fractal_noise(u, v, {3, 3, 71}, 5);
  const double fine = fractal_noise(u, v, {5, 5, 72}, 4);
  const double cloud = fractal_noise(u, v, {2, 2, 73}, 4);
  const double vein = 1 - smooth_step(0.0, 0.09, std::abs(fraction(u + v + 1.4 * bend) - 0.5));
  const double thin = 1 - smooth_step(0.0, 0.04, std::abs(fraction(2 * u - v + fine) - 0.5));
  return 0.84 + 0.2 * (cloud - 0.5) - 0.36 * vein * cloud - 0.2 * thin * (1 - cloud);
}

Color tile_color(double u, double v) {
  const double x = fraction(u * 2) - 0.5;
  const double y = fraction(v * 2) - 0.5;
  const double radius = radius_of(x, y);
  const double corner = radius_of(0.5 - std::abs(x), 0.5 - std::abs(y));
  const double ring = smooth_step(0.3, 0.28, radius) * smooth_step(0.2, 0.22, radius);
  const double star = smooth_step(0.14, 0.12, std::abs(x) + std::abs(y));
  const double quarter = smooth_step(0.3, 0.28, corner) * smooth_step(0.16, 0.18, corner);
  const double joint = 1 - smooth_step(0.01, 0.02, 0.5 - std::max(std::abs(x), std::abs(y)));
  const Color ground = rgb(0xe2dccb) * (0.94 + 0.08 * noise(u, v, {6, 6, 81}));
  Color color = mix(ground, rgb(0x35577a), std::min(1.0, ring + quarter));
  color = mix(color, rgb(0xb8763a), star);
  return mix(color, rgb(0x8e887c), joint);
}

double cardboard_grey(double u, double v) {
  const double flutes = wave(u * 40);
  const double stains = fractal_noise(u, v, {3, 3, 91}, 3);
  return 0.74 + 0.05 * flutes + 0.18 * stains;
}

Color leaf_color(double u, double v) {
  const double x = std::abs(u - 0.5) * 2;
  const double midrib = 1 - smooth_step(0.02, 0.07, x);
  const double ribs = 1 - smooth_step(0.0, 0.18, std::abs(fraction(v * 9 + x * 1.6) - 0.5));
  const double mottle = fractal_noise(u, v, {5, 9, 95}, 3);
  const Color blade = mix(rgb(0x27492a), rgb(0x5f8a45), 0.25 * ribs + 0.75 * mottle);
  return mix(blade, rgb(0xa3b872), 0.8 * midrib);
}

/// A stripe of a tartan, up to `end` of the sett's width.
struct Stripe {
  double end = 1;
  Color color = Color::Ones();
};

Color stripe_color(const std::vector<Stripe>& sett, double t) {
  const auto stripe = std::find_if(sett.begin(), sett.end(),
                                   [t](const Stripe& candidate) { return t < candidate.end; });
  return stripe->color;
}

/// Returns the colour of a cloth whose warp and weft have the same stripes.
Color tartan_color(const std::vector<Stripe>& sett, double u, double v) {
  const double wear = fractal_noise(u, v, {6, 6, 101}, 3);
  return mix(stripe_color(sett, u), stripe_color(sett, v), 0.5) * (0.88 + 0.2 * wear);
}

}  // namespace

cv::Mat floor_planks_texture() {
  return paint(plank_color, {1024, 1024, 4});
}
cv::Mat brick_texture() {
  return paint(brick_color, {1024, 512, 6});
}
cv::Mat plaster_texture() {
  return paint_grey(
      [](double u, double v) {
        return 0.9 + 0.1 * fractal_noise(u, v, {5, 5, 35}, 5);
      },
      {256, 256, 2});
}
cv::Mat wallpaper_texture() {
  return paint(wallpaper_color, {256, 256, 4});
}
cv::Mat wood_texture() {
  return paint_grey(wood_grey, {512, 256, 4});
}
cv::Mat fabric_texture() {
  return paint_grey(fabric_grey, {256, 256, 6});
}
cv::Mat carpet_texture() {
  return paint_grey(carpet_grey, {256, 256, 6});
}
cv::Mat marble_texture() {
  return paint_grey(marble_grey, {512, 512, 4});
}
cv::Mat tiles_texture() {
  return paint(tile_color, {256, 256, 6});
}
cv::Mat cardboard_texture() {
  return paint_grey(cardboard_grey, {256, 256, 4});
}
cv::Mat leaf_texture() {
  return paint(leaf_color, {128, 256, 6});
}
cv::Mat tartan_texture() {
  const std::vector<Stripe> sett = {
      {0.34, rgb(0x94403a)}, {0.38, rgb(0xcbb89c)}, {0.62, rgb(0x3d4566)}, {0.66, rgb(0xcbb89c)},
      {0.80, rgb(0x94403a)}, {0.84, rgb(0x3a3238)}, {0.90, rgb(0xb98f4c)}, {1.00, rgb(0x3a3238)}};
  return paint([&](double u, double v) { return tartan_color(sett, u, v); }, {256, 256, 8});
}
cv::Mat trousers_texture() {
  const std::vector<Stripe> sett = {{0.30, rgb(0x4d5358)}, {0.36, rgb(0x8f8d84)},
                                    {0.52, rgb(0x3a4046)}, {0.55, rgb(0x9a978b)},
                                    {0.82, rgb(0x5a6066)}, {1.00, rgb(0x2d3236)}};
  return paint([&](double u, double v) { return tartan_color(sett, u, v); }, {256, 256, 8});
}

}  // namespace scenes
