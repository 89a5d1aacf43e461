#pragma once

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/quads.h"

namespace synth {

inline constexpr int kRows = 64;  // of squares, on a ball
inline constexpr int kCopies = 14;

/// Bumpy and smooth, not at the middle of its frame: 8192 triangles.
inline Mesh ball() {
  Mesh mesh;
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kRows; ++column) {
      const double theta = std::numbers::pi * row / kRows;
      const double phi = 2 * std::numbers::pi * column / kRows;
      const Eigen::Vector3d normal(std::sin(theta) * std::cos(phi), std::cos(theta),
                                   std::sin(theta) * std::sin(phi));
      const double radius = 0.5 + 0.05 * std::sin(5 * theta) * std::sin(6 * phi);
      mesh.positions.emplace_back((radius * normal + Eigen::Vector3d(3, 0.5, 0)).cast<float>());
      mesh.normals.emplace_back(normal.cast<float>());
      mesh.texcoords[0].emplace_back(static_cast<float>(4 * column) / kRows,
                                     static_cast<float>(2 * row) / kRows);
    }
  }
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kRows; ++column) {
      const int a = row * (kRows + 1) + column;
      const int b = a + kRows + 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, a + 1, b}, {a + 1, b + 1, b}});
    }
  }
  return mesh;
}

/// Black and white, with holes where it is black.
inline TextureImage checker() {
  TextureImage image;
  for (int size = 8; size > 0; size /= 2) {
    cv::Mat_<cv::Vec4b> level(size, size, cv::Vec4b(128, 128, 128, 128));
    for (int i = 0; size == 8 && i < size * size; ++i) {
      const bool is_white = (i % size + i / size) % 2 == 0;
      level(i / size, i % size) = is_white ? cv::Vec4b(255, 200, 90, 255) : cv::Vec4b(0, 0, 0, 0);
    }
    image.levels.push_back(level);
  }
  return image;
}

/// Where the copies stand: turned, mirrored, stretched and one of them sheared.
inline Eigen::Affine3d place(int copy) {
  const int row = copy / 5;
  const Eigen::Vector3d at(copy % 5 - 2.2, 0.9 * row - 1, 3 + 0.3 * (copy % 3));
  const double side = copy % 3 == 1 ? -0.7 : 0.7;
  Eigen::Affine3d T = Eigen::Translation3d(at) *
                      Eigen::AngleAxisd(0.7 * copy, Eigen::Vector3d(1, 2, 3).normalized()) *
                      Eigen::Scaling(side, 0.5 + 0.05 * copy, 0.6) *
                      Eigen::Translation3d(-3, -0.5, 0);
  if (copy == 7) {
    T.linear().col(0) += 40 * T.linear().col(1);
  }
  return T;
}

/// Copies of two meshes, one of them with holes, before a wall, in the light of a lamp.
inline Scene copies() {
  Scene scene;
  add(scene, square_at(5, 16), diffuse({0.5F, 0.6F, 0.7F}));
  add(scene, ball(), diffuse({0.9F, 0.5F, 0.3F}));
  add(scene, ball(), diffuse({1, 1, 1}));
  scene.images.push_back(checker());
  scene.textures.push_back({.image = 0});
  scene.materials[2].base_color_texture.texture = 0;
  scene.materials[2].alpha_mode = AlphaMode::mask;
  scene.instances.resize(1);
  for (int copy = 0; copy < 2 * kCopies; ++copy) {
    scene.instances.push_back({.mesh = 1 + copy % 2, .T_world_mesh = place(copy)});
  }
  scene.lights.push_back(point_light({-1, -3, 0.5}, {40, 40, 30}));
  return scene;
}

/// The same with a mesh of its own for each.
inline Scene apart(const Scene& scene) {
  Scene result = scene;
  result.meshes.clear();
  for (Instance& instance : result.instances) {
    result.meshes.push_back(scene.meshes[instance.mesh]);
    instance.mesh = static_cast<int>(result.meshes.size()) - 1;
  }
  return result;
}

inline vo::PinholeCamera camera() {
  return vo::PinholeCamera::from_horizontal_fov(160, 120, 70);
}

/// How two pictures of the same differ.
struct Difference {
  int ids = 0;       ///< pixels
  int depths = 0;    ///< pixels of the same ids, by more than the tolerated share
  int normals = 0;   ///< the same, by more than 1e-3
  int colors = 0;    ///< pixels, by more than 0.01
  int compared = 0;  ///< pixels that see something
};

inline Difference difference(const RenderedFrame& a, const RenderedFrame& b,
                             float depth_tolerance) {
  Difference result;
  for (int v = 0; v < a.depth.rows; ++v) {
    for (int u = 0; u < a.depth.cols; ++u) {
      result.compared += a.depth(v, u) > 0 ? 1 : 0;
      const bool is_same = a.instance(v, u) == b.instance(v, u);
      result.ids += is_same && a.material(v, u) == b.material(v, u) ? 0 : 1;
      const float step = std::abs(a.depth(v, u) - b.depth(v, u));
      result.depths += is_same && step > depth_tolerance * a.depth(v, u) ? 1 : 0;
      result.normals += is_same && cv::norm(a.normal(v, u) - b.normal(v, u)) > 1e-3 ? 1 : 0;
      result.colors += cv::norm(a.radiance(v, u) - b.radiance(v, u)) > 0.01 ? 1 : 0;
    }
  }
  return result;
}

/// Rays along edges may meet or miss them, and a triangle's neighbour, by rounding.
inline void expect_same(const RenderedFrame& a, const RenderedFrame& b,
                        float depth_tolerance = 1e-6F) {
  const Difference differing = difference(a, b, depth_tolerance);
  const int few = static_cast<int>(a.depth.total() / 1000);
  EXPECT_GT(differing.compared, 10'000);
  EXPECT_LE(differing.ids, few);
  EXPECT_LE(differing.depths, few);
  EXPECT_LE(differing.normals, few);
  EXPECT_LE(differing.colors, 2 * few);
}

inline Capture all_of(const Capture& capture) {
  Capture result = capture;
  result.channels = {.color = true, .depth = true, .normal = true, .ids = true};
  return result;
}

}  // namespace synth
