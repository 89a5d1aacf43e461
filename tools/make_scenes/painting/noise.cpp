#include "tools/make_scenes/painting/noise.h"

#include <algorithm>
#include <cmath>

namespace scenes {
namespace {

std::uint32_t scramble(std::uint32_t x) {
  x = (x ^ (x >> 16U)) * 0x7feb352dU;
  x = (x ^ (x >> 15U)) * 0x846ca68bU;
  return x ^ (x >> 16U);
}

int wrap(int index, int count) {
  return ((index % count) + count) % count;
}

double ease(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

}  // namespace

double random01(std::uint32_t seed, int i, int j) {
  const std::uint32_t bits =
      scramble(scramble(scramble(seed + 0x9e3779b9U) + static_cast<std::uint32_t>(i)) * 31U +
               static_cast<std::uint32_t>(j));
  return static_cast<double>(bits) / 4294967296.0;
}

double noise(double u, double v, const Lattice& lattice) {
  const double x = u * lattice.columns;
  const double y = v * lattice.rows;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const auto corner = [&](int dx, int dy) {
    return random01(lattice.seed, wrap(column + dx, lattice.columns), wrap(row + dy, lattice.rows));
  };
  const double a = ease(x - column);
  const double b = ease(y - row);
  const double top = corner(0, 0) * (1 - a) + corner(1, 0) * a;
  const double bottom = corner(0, 1) * (1 - a) + corner(1, 1) * a;
  return top * (1 - b) + bottom * b;
}

double fractal_noise(double u, double v, const Lattice& coarsest, int octaves) {
  Lattice lattice = coarsest;
  double sum = 0;
  double weight = 1;
  double total = 0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * noise(u, v, lattice);
    total += weight;
    weight /= 2;
    lattice = {lattice.columns * 2, lattice.rows * 2, lattice.seed + 1};
  }
  return sum / total;
}

double wave(double t) {
  const double tent = 1 - std::abs(2 * fraction(t) - 1);
  return tent * tent * (3 - 2 * tent);
}

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double fraction(double x) {
  return x - std::floor(x);
}

double radius_of(double x, double y) {
  return std::sqrt(x * x + y * y);
}

}  // namespace scenes
