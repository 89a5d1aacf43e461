#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/scene/scene.h"

namespace synth {

/// A point of a triangle in barycentric coordinates, so that it moves with the triangle.
struct TrianglePoint {
  int mesh = kNone;      ///< index into WorldGeometry::meshes; kNone = no hit
  int triangle = kNone;  ///< index into Mesh::triangles
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< barycentric, sum 1
  double depth = 0;                                   ///< m, CameraModel::depth

  bool exists() const { return mesh != kNone; }
};

/// The surface points seen at the pixels' centres, row by row.
struct PointImage {
  cv::Size size;
  std::vector<TrianglePoint> points;

  const TrianglePoint& at(int u, int v) const { return points[index(u, v)]; }
  TrianglePoint& at(int u, int v) { return points[index(u, v)]; }

 private:
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(u);
  }
};

}  // namespace synth
