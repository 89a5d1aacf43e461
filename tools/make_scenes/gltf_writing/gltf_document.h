#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/make_scenes/painting/finish.h"

namespace scenes {

using Json = nlohmann::ordered_json;

inline constexpr int kFloat = 5126;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kUnsignedShort = 5123;

/// The parts of the buffer in order, one buffer view each unless it is empty.
enum View : std::size_t {
  positions,
  normals,
  texcoords,
  colors,
  indices,
  animation,
  joints,
  weights,
  binds,
  view_count
};

inline constexpr double kGrid = 65536;  ///< grid steps per m, and per unit of texture coordinates
inline constexpr double kUnitGrid = 4096;  ///< grid steps per unit, for components of unit vectors
inline constexpr double kFineGrid = 1e6;   ///< grid steps per m or unit, for nodes

/// Returns the value rounded to 1 / `grid`, so that mathematical libraries make no difference.
inline double snapped(double value, double grid) {
  return std::floor(value * grid + 0.5) / grid;
}

/// A glTF document under construction.
struct Document {
  Json json;
  std::vector<Finish> finishes;  ///< finishes in the order of the materials
  std::array<std::string, view_count> views;
};

template <typename Scalar>
void write_little_endian(std::string& bytes, Scalar value) {
  static_assert(sizeof(Scalar) <= sizeof(std::uint32_t));
  for (std::size_t i = 0; i < sizeof(Scalar); ++i) {
    bytes.push_back(static_cast<char>(value >> (8 * i) & 255U));
  }
}

void write_float(std::string& bytes, double value, double grid);

/// Adds an accessor of `count` elements that begin at `offset` of the view and returns its index.
int add_accessor(Document& document, View view, std::size_t offset, std::size_t count,
                 const Json& format);

/// Adds the buffer views that the accessors refer to and returns the buffer's bytes.
std::string join_views(Document& document);

}  // namespace scenes
