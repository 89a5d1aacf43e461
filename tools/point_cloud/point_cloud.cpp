#include "tools/point_cloud/point_cloud.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

static_assert(std::endian::native == std::endian::little, "both formats are written as they lie");

/// Appends a value's bytes.
template <typename Value>
void append(std::string& bytes, const Value& value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  bytes.append(raw.data(), raw.size());
}

std::string ply_header(std::size_t points) {
  return vo::concat(
      "ply\nformat binary_little_endian 1.0\ncomment edge points, world frame, m\nelement vertex ",
      points,
      "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty float inverse_depth_sigma\n"
      "end_header\n");
}

std::string pcd_header(std::size_t points) {
  return vo::concat(
      "# .PCD v0.7 - edge points, world frame, m\nVERSION 0.7\n"
      "FIELDS x y z rgb inverse_depth_sigma\nSIZE 4 4 4 4 4\nTYPE F F F U F\nCOUNT 1 1 1 1 1\n"
      "WIDTH ",
      points, "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS ", points, "\nDATA binary\n");
}

void append_ply(std::string& bytes, const CloudPoint& point) {
  bytes.append(3, static_cast<char>(point.grey));
}

void append_pcd(std::string& bytes, const CloudPoint& point) {
  constexpr std::uint32_t kEachColour = 0x010101;
  append(bytes, kEachColour * point.grey);
}

}  // namespace

std::uint8_t grey_of(float intensity) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(intensity, 0.0F, 1.0F)));
}

CloudFormat cloud_format_of(const std::filesystem::path& path) {
  if (path.extension() != ".ply" && path.extension() != ".pcd") {
    vo::fail_as(vo::ErrorKind::usage, path.string(), ": expected a name that ends in .ply or .pcd");
  }
  return vo::parse_enum<CloudFormat>(path.extension().string().substr(1));
}

std::string encode(const EdgeCloud& cloud, CloudFormat format) {
  constexpr std::size_t kPointBytes = 20;
  const bool is_ply = format == CloudFormat::ply;
  std::string bytes = is_ply ? ply_header(cloud.size()) : pcd_header(cloud.size());
  bytes.reserve(bytes.size() + kPointBytes * cloud.size());
  for (const CloudPoint& point : cloud) {
    for (const float coordinate : point.p_world) {
      append(bytes, coordinate);
    }
    is_ply ? append_ply(bytes, point) : append_pcd(bytes, point);
    append(bytes, point.inverse_depth_sigma);
  }
  return bytes;
}

}  // namespace tools
