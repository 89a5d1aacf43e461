#pragma once

#include <cstdint>

namespace scenes {

/// Returns a pseudo-random number in [0, 1) from its arguments by integer arithmetic.
double random01(std::uint32_t seed, int i, int j = 0);

/// Cells per tile of a noise, and its seed.
struct Lattice {
  int columns = 4;
  int rows = 4;
  std::uint32_t seed = 0;
};

/// Returns smooth noise in [0, 1] that has period 1 in u and v.
double noise(double u, double v, const Lattice& lattice);

/// Returns the weighted mean of `octaves` noises, each with half the cell size and weight of the
/// one before.
double fractal_noise(double u, double v, const Lattice& coarsest, int octaves);

/// Returns a smooth wave of period 1: 0 at integers, 1 halfway between them.
double wave(double t);

/// Returns 0 below `from`, 1 above `to` and a cubic in between.
double smooth_step(double from, double to, double x);

/// Returns x minus the largest integer not above it.
double fraction(double x);

/// Returns the distance of (x, y) from the origin.
double radius_of(double x, double y);

}  // namespace scenes
