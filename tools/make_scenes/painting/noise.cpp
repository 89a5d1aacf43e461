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

/// An index of a lattice of `count` and the next one, where the last is beside the first.
struct Neighbours {
  int here;
  int next;
};

Neighbours wrap(int index, int count) {
  const int here = ((index % count) + count) % count;
  return {here, here + 1 < count ? here + 1 : 0};
}

/// Returns the bits that all random numbers with this seed and first index begin with.
std::uint32_t scramble_line(std::uint32_t seed, int i) {
  return scramble(scramble(seed + 0x9e3779b9U) + static_cast<std::uint32_t>(i));
}

double random01_on(std::uint32_t line, int j) {
  return static_cast<double>(scramble(line * 31U + static_cast<std::uint32_t>(j))) / 4294967296.0;
}

double ease(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

}  // namespace

double random01(std::uint32_t seed, int i, int j) {
  return random01_on(scramble_line(seed, i), j);
}

double noise(double u, double v, const Lattice& lattice) {
  const double x = u * lattice.columns;
  const double y = v * lattice.rows;
  const double column = std::floor(x);
  const double row = std::floor(y);
  const Neighbours columns = wrap(static_cast<int>(column), lattice.columns);
  const Neighbours rows = wrap(static_cast<int>(row), lattice.rows);
  const std::uint32_t left = scramble_line(lattice.seed, columns.here);
  const std::uint32_t right = scramble_line(lattice.seed, columns.next);
  const double a = ease(x - column);
  const double b = ease(y - row);
  const double top = random01_on(left, rows.here) * (1 - a) + random01_on(right, rows.here) * a;
  const double bottom = random01_on(left, rows.next) * (1 - a) + random01_on(right, rows.next) * a;
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
