#pragma once

#include <cstdint>

namespace scenes {

/// A number in [0, 1) that is a fixed function of its arguments, by integer arithmetic alone.
double random01(std::uint32_t seed, int i, int j = 0);

/// Cells per tile of a noise, and which noise it is.
struct Lattice {
  int columns = 4;
  int rows = 4;
  std::uint32_t seed = 0;
};

/// Smooth noise in [0, 1] over the unit square, which it continues beyond periodically.
double noise(double u, double v, const Lattice& lattice);

/// The weighted mean of `octaves` noises, each twice as fine and half as strong as the one before.
double fractal_noise(double u, double v, const Lattice& coarsest, int octaves);

/// A smooth wave of period 1 between 0 (at integers) and 1.
double wave(double t);

/// 0 below `from`, 1 above `to`, a cubic between.
double smooth_step(double from, double to, double x);

/// x minus the integer below it.
double fraction(double x);

/// The distance of (x, y) from the origin.
double radius_of(double x, double y);

}  // namespace scenes
