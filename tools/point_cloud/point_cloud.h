#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace tools {

/// An edge pixel of a keyframe as a point in the world, with the uncertainty of its depth.
struct CloudPoint {
  Eigen::Vector3f p_world;        ///< m
  std::uint8_t grey = 0;          ///< the keyframe's intensity there
  float inverse_depth_sigma = 0;  ///< 1/m, standard deviation of the inverse depth in the keyframe
};

using EdgeCloud = std::vector<CloudPoint>;

/// Returns an intensity, 0..1, as a grey, 0..255.
std::uint8_t grey_of(float intensity);

/// The formats of point clouds, named as their files end.
enum class CloudFormat { ply, pcd };

constexpr auto enum_names(CloudFormat) {
  return std::array{std::pair{CloudFormat::ply, "ply"}, std::pair{CloudFormat::pcd, "pcd"}};
}

/// Returns the format that a file's ending names. Throws Error of kind `usage` for another ending.
CloudFormat cloud_format_of(const std::filesystem::path& path);

/// Returns a cloud as binary little-endian PLY (x, y, z in m, red, green, blue, inverse_depth_sigma
/// in 1/m) or as binary PCD 0.7 (x, y, z, rgb, inverse_depth_sigma), which Open3D, PCL,
/// CloudCompare and MeshLab read.
std::string encode(const EdgeCloud& cloud, CloudFormat format);

}  // namespace tools
