#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include "vo/core/hash.h"

namespace synth {

/// Returns the bits of a number in reverse order.
constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x & 0x55555555U) << 1U | (x >> 1U & 0x55555555U);
  x = (x & 0x33333333U) << 2U | (x >> 2U & 0x33333333U);
  x = (x & 0x0f0f0f0fU) << 4U | (x >> 4U & 0x0f0f0f0fU);
  return (x & 0xffU) << 24U | (x & 0xff00U) << 8U | (x >> 8U & 0xff00U) | x >> 24U;
}

/// Returns the number with each bit flipped or not as a hash of the lower bits says, which on
/// reversed bits is Owen's scrambling (Laine & Karras, Stratified sampling for stochastic
/// transparency, 2011; constants of Burley, Practical hash-based Owen scrambling, 2020).
constexpr std::uint32_t flipped_upwards(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return x;
}

/// What the bytes of an index, the lowest first, contribute to the second coordinate of Sobol's
/// sequence, as fractions of 2^32 with their bits reversed. The columns of that coordinate's matrix
/// are the rows of Pascal's triangle modulo 2; the first coordinate is the index reversed.
using SobolTable = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr SobolTable sobol_table() {
  SobolTable table{};
  std::uint32_t column = 1U << 31U;
  for (auto& of_byte : table) {
    for (std::size_t bit = 1; bit < of_byte.size(); bit <<= 1U, column ^= column >> 1U) {
      for (std::size_t lower = 0; lower < bit; ++lower) {
        of_byte.at(bit + lower) = of_byte.at(lower) ^ reversed_bits(column);
      }
    }
  }
  return table;
}

inline constexpr SobolTable kSobolTable = sobol_table();

/// Returns the n-th point of Sobol's sequence in [0, 1) x [0, 1), scrambled and taken in an order
/// that random `bits` encode. Of the first 2^m points every box of 2^-a x 2^-(m - a) holds one.
/// Sequences of different bits are independent of each other, so that several span more dimensions.
inline Eigen::Vector2f scrambled_sobol(std::uint64_t bits, int n) {
  const auto of_order = static_cast<std::uint32_t>(bits >> 32U);
  const auto of_first = static_cast<std::uint32_t>(bits);
  const auto of_second = static_cast<std::uint32_t>(vo::mixed(bits));
  const std::uint32_t index =
      reversed_bits(flipped_upwards(reversed_bits(static_cast<std::uint32_t>(n)), of_order));
  const std::uint32_t second = kSobolTable[0][index & 0xffU] ^ kSobolTable[1][index >> 8U & 0xffU] ^
                               kSobolTable[2][index >> 16U & 0xffU] ^ kSobolTable[3][index >> 24U];
  const auto unit = [](std::uint32_t reversed) {
    return static_cast<float>(reversed_bits(reversed) >> 8U) * 0x1p-24F;
  };
  return {unit(flipped_upwards(index, of_first)), unit(flipped_upwards(second, of_second))};
}

}  // namespace synth
