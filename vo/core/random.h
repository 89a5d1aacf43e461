#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace vo {

/// Random numbers that depend on the seed alone, whatever the standard library, unlike those of
/// <random>'s distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Starts one of many unrelated streams of random numbers of a seed.
  Random(std::uint64_t seed, std::uint64_t stream)
      : engine_((seed + 1) * 0x9e3779b97f4a7c15ULL ^ (stream + 1) * 0xd1b54a32d192ed03ULL) {}

  std::uint64_t bits() { return engine_(); }
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  ///< [0, 1)
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  int below(int count) { return static_cast<int>(uniform() * count); }

  /// Returns a normally distributed number of mean 0 and variance 1 (Box & Muller).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace vo
