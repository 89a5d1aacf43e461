#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tools/make_scenes/model/shape.h"

namespace scenes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// One of a box's six sides: outward `normal`, and `right` and `up` as seen from outside.
struct Side {
  Vector3d normal;
  Vector3d right;
  Vector3d up;
};

std::array<Side, 6> sides() {
  const Vector3d x = Vector3d::UnitX();
  const Vector3d y = Vector3d::UnitY();
  const Vector3d z = Vector3d::UnitZ();
  return {Side{x, -z, y},  Side{-x, z, y}, Side{z, x, y},
          Side{-z, -x, y}, Side{y, x, -z}, Side{-y, x, z}};
}

int add_vertex(Shape& shape, const Vector3d& position, const Side& side) {
  shape.positions.push_back(position);
  shape.normals.push_back(side.normal);
  shape.texcoords.emplace_back(position.dot(side.right), -position.dot(side.up));
  return static_cast<int>(shape.positions.size()) - 1;
}

void add_triangle(Shape& shape, const std::array<int, 3>& corners, const Vector3d& outward) {
  const auto position = [&](int i) { return shape.positions[static_cast<std::size_t>(i)]; };
  const auto& [a, b, c] = corners;
  const Vector3d normal = (position(b) - position(a)).cross(position(c) - position(a));
  shape.triangles.push_back(normal.dot(outward) > 0 ? corners : std::array<int, 3>{a, c, b});
}

/// Returns the index of the vertex at a corner of the side across `axis`; the corner's bits are its
/// signs.
int vertex_of(int axis, int corner) {
  return axis * 8 + corner;
}

Vector3d corner_signs(int corner) {
  return {(corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
          (corner & 4) != 0 ? 1.0 : -1.0};
}

void add_quad(Shape& shape, const std::array<int, 4>& ring, const Vector3d& outward) {
  add_triangle(shape, {ring[0], ring[1], ring[2]}, outward);
  add_triangle(shape, {ring[0], ring[2], ring[3]}, outward);
}

Side side_across(int axis, bool positive) {
  constexpr std::array<std::array<std::size_t, 2>, 3> kIndex = {{{1, 0}, {5, 4}, {3, 2}}};
  return sides().at(kIndex.at(static_cast<std::size_t>(axis)).at(positive ? 1 : 0));
}

void add_box_side(Shape& shape, int axis, int sign_bit) {
  const int b = 1 << ((axis + 1) % 3);
  const int c = 1 << ((axis + 2) % 3);
  const int base = sign_bit << axis;
  add_quad(shape,
           {vertex_of(axis, base), vertex_of(axis, base | b), vertex_of(axis, base | b | c),
            vertex_of(axis, base | c)},
           corner_signs(base)[axis] * Vector3d::Unit(axis));
}

/// Adds the four bevels parallel to `axis`.
void add_bevels(Shape& shape, int axis) {
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  for (int edge = 0; edge < 4; ++edge) {
    const int from = (edge & 1) << b | (edge >> 1) << c;
    const int to = from | 1 << axis;
    const Vector3d signs = corner_signs(from);
    add_quad(shape, {vertex_of(b, from), vertex_of(b, to), vertex_of(c, to), vertex_of(c, from)},
             signs[b] * Vector3d::Unit(b) + signs[c] * Vector3d::Unit(c));
  }
}

/// Maps a point of a face of the cube -1..1 to the box with rounded edges.
Vector3d rounded(const Vector3d& cube, const Vector3d& half, double radius, Vector3d* normal) {
  const Vector3d inner = half - Vector3d::Constant(radius);
  const Vector3d core = cube.cwiseMax(-inner).cwiseMin(inner);
  *normal = (cube - core).normalized();
  return core + radius * *normal;
}

/// Returns the divisions of a soft box's side of half length `half`, denser at its ends.
std::vector<double> soft_divisions(double half, double radius, int segments) {
  std::vector<double> divisions;
  for (int i = segments; i >= 0; --i) {
    const double angle = std::numbers::pi / 4 * i / segments;
    divisions.push_back(radius - half - radius * std::tan(angle));
  }
  for (int i = segments; i >= 0; --i) {
    divisions.push_back(-divisions[static_cast<std::size_t>(i)]);
  }
  return divisions;
}

void add_soft_side(Shape& shape, const Side& side, const Vector3d& half, double radius,
                   int segments) {
  const auto columns = soft_divisions(half.dot(side.right.cwiseAbs()), radius, segments);
  const auto rows = soft_divisions(half.dot(side.up.cwiseAbs()), radius, segments);
  const int first = static_cast<int>(shape.positions.size());
  for (const double v : rows) {
    for (const double u : columns) {
      Vector3d normal;
      const Vector3d cube =
          half.dot(side.normal.cwiseAbs()) * side.normal + u * side.right - v * side.up;
      add_vertex(shape, rounded(cube, half, radius, &normal), side);
      shape.normals.back() = normal;
    }
  }
  const int stride = static_cast<int>(columns.size());
  for (int row = 0; row + 1 < stride; ++row) {
    for (int a = first + row * stride; a + 1 < first + (row + 1) * stride; ++a) {
      add_quad(shape, {a, a + 1, a + stride + 1, a + stride}, side.normal);
    }
  }
}

}  // namespace

Shape box(const Vector3d& size, double bevel) {
  Shape shape;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d signs = corner_signs(corner);
      Vector3d position = signs.cwiseProduct(size / 2 - Vector3d::Constant(bevel));
      position[axis] = signs[axis] * size[axis] / 2;
      add_vertex(shape, position, side_across(axis, signs[axis] > 0));
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    add_box_side(shape, axis, 0);
    add_box_side(shape, axis, 1);
    if (bevel > 0) {
      add_bevels(shape, axis);
    }
  }
  for (int corner = 0; bevel > 0 && corner < 8; ++corner) {
    add_triangle(shape, {vertex_of(0, corner), vertex_of(1, corner), vertex_of(2, corner)},
                 corner_signs(corner));
  }
  return shape;
}

Shape plank(const Vector3d& size, double bevel) {
  Shape shape = box(size, bevel);
  int longest = 0;
  size.maxCoeff(&longest);
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    int across = 0;
    Vector3d along_normal = shape.normals[i].cwiseAbs();
    along_normal[longest] = 2;
    along_normal.minCoeff(&across);
    const Vector3d& p = shape.positions[i];
    // The last term gives parts of different sizes different pieces of the wood texture.
    shape.texcoords[i] = Vector2d(p[longest], p[across] + 7 * size.sum());
  }
  return shape;
}

Shape soft_box(const Vector3d& size, double radius, int segments) {
  Shape shape;
  for (const Side& side : sides()) {
    add_soft_side(shape, side, size / 2, radius, segments);
  }
  return shape;
}

}  // namespace scenes
