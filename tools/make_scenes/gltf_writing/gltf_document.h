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

/// The parts of the buffer, one buffer view each unless it is empty, in this order.
enum View : std::size_t { positions, normals, texcoords, colors, indices, animation, view_count };

inline constexpr double kGrid = 65536;     ///< per m, and per unit of texture coordinates
inline constexpr double kUnitGrid = 4096;  ///< per unit, of unit vectors' components
inline constexpr double kFineGrid = 1e6;   ///< per m or unit, of nodes

/// Rounded to 1 / `grid`, so that no machine's mathematical library shows in the file.
inline double snapped(double value, double grid) {
  return std::floor(value * grid + 0.5) / grid;
}

/// The file under construction.
struct Document {
  Json json;
  std::vector<Finish> finishes;  ///< whose materials it holds, in their order
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

/// Index of a new accessor of `count` elements that begin at `offset` of the view.
int add_accessor(Document& document, View view, std::size_t offset, std::size_t count,
                 const Json& format);

/// Adds the buffer views, as the buffer's parts that the accessors refer to; returns the buffer.
std::string join_views(Document& document);

}  // namespace scenes
