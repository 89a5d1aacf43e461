#include "tools/make_scenes/model/shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace scenes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

int add_vertex(Shape& shape, const Vector3d& position, const Vector3d& normal,
               const Vector2d& texcoord) {
  shape.positions.push_back(position);
  shape.normals.push_back(normal);
  shape.texcoords.push_back(texcoord);
  return static_cast<int>(shape.positions.size()) - 1;
}

/// Adds two triangles of a grid cell with the corners a b (top), c d (bottom), seen from outside.
void add_cell(Shape& shape, int a, int b, int c, int d) {
  shape.triangles.push_back({a, c, b});
  shape.triangles.push_back({b, c, d});
}

/// Returns the outward unit normal of the profile from point i - 1 to i; zero without such a
/// segment.
Vector2d segment_normal(const std::vector<Vector2d>& profile, std::size_t i) {
  if (i == 0 || i == profile.size() || profile[i] == profile[i - 1]) {
    return Vector2d::Zero();
  }
  const Vector2d d = profile[i] - profile[i - 1];
  return Vector2d(d.y(), -d.x()).normalized();
}

double largest_radius(const std::vector<Vector2d>& profile) {
  double radius = 0;
  for (const Vector2d& point : profile) {
    radius = std::max(radius, point.x());
  }
  return radius;
}

double arc_length(const std::vector<Vector2d>& profile) {
  double length = 0;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    length += (profile[i] - profile[i - 1]).norm();
  }
  return length;
}

void add_ring(Shape& shape, const std::vector<Vector2d>& profile, std::size_t i,
              const Vector2d& turn_and_v, int segments) {
  const Vector2d normal =
      (segment_normal(profile, i) + segment_normal(profile, i + 1)).normalized();
  for (int j = 0; j <= segments; ++j) {
    const double angle = 2 * kPi * (j % segments) / segments;
    const Vector3d out(std::cos(angle), 0, -std::sin(angle));
    add_vertex(shape, profile[i].x() * out + profile[i].y() * Vector3d::UnitY(),
               normal.x() * out + normal.y() * Vector3d::UnitY(),
               {turn_and_v.x() * j / segments, turn_and_v.y()});
  }
}

/// Adds the cells between ring i - 1 and ring i, except those that degenerate on the axis.
void add_band(Shape& shape, const std::vector<Vector2d>& profile, std::size_t i, int segments) {
  const int upper = static_cast<int>(i) * (segments + 1);
  const int lower = upper - segments - 1;
  for (int j = 0; j < segments; ++j) {
    if (profile[i - 1].x() > 0) {
      shape.triangles.push_back({upper + j, lower + j, lower + j + 1});
    }
    if (profile[i].x() > 0) {
      shape.triangles.push_back({upper + j, lower + j + 1, upper + j + 1});
    }
  }
}

}  // namespace

Shape lathe(const std::vector<Vector2d>& profile, int segments) {
  Shape shape;
  const double turn = 2 * kPi * largest_radius(profile);
  double v = arc_length(profile);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double step = i > 0 ? (profile[i] - profile[i - 1]).norm() : 0;
    v -= step;
    add_ring(shape, profile, i, {turn, v}, segments);
    if (step > 0) {
      add_band(shape, profile, i, segments);
    }
  }
  return shape;
}

Shape cylinder(double radius, double height, int segments) {
  const Vector2d bottom(radius, 0);
  const Vector2d top(radius, height);
  return lathe({{0, 0}, bottom, bottom, top, top, {0, height}}, segments);
}

Shape sphere(double radius, int segments) {
  const int rings = segments / 2;
  std::vector<Vector2d> profile = {{0, -radius}};
  for (int i = 1; i < rings; ++i) {
    const double angle = kPi * i / rings;
    profile.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
  }
  profile.emplace_back(0, radius);
  return lathe(profile, segments);
}

Shape rectangle(const Vector3d& corner, const Vector3d& right, const Vector3d& down,
                const Vector2d& origin) {
  Shape shape;
  const Vector3d normal = down.cross(right).normalized();
  const Vector2d size(right.norm(), down.norm());
  for (const Vector2d& t : {Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1), Vector2d(1, 1)}) {
    add_vertex(shape, corner + t.x() * right + t.y() * down, normal, origin + t.cwiseProduct(size));
  }
  add_cell(shape, 0, 1, 2, 3);
  return shape;
}

Shape panel(double width, double height) {
  Shape shape = rectangle({-width / 2, height / 2, 0}, {width, 0, 0}, {0, -height, 0});
  for (Vector2d& texcoord : shape.texcoords) {
    texcoord = texcoord.cwiseQuotient(Vector2d(width, height));
  }
  return shape;
}

Shape disc(double radius, int segments) {
  Shape shape;
  add_vertex(shape, Vector3d::Zero(), Vector3d::UnitZ(), {0.5, 0.5});
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * kPi * i / segments;
    const Vector2d rim(std::cos(angle), std::sin(angle));
    add_vertex(shape, {radius * rim.x(), radius * rim.y(), 0}, Vector3d::UnitZ(),
               {0.5 + rim.x() / 2, 0.5 - rim.y() / 2});
    shape.triangles.push_back({0, 1 + i, 1 + (i + 1) % segments});
  }
  return shape;
}

Shape sheet(const std::function<Vector3d(double u, double v)>& f, const SheetGrid& grid) {
  constexpr double kStep = 1e-4;
  Shape shape;
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column) {
      const double u = static_cast<double>(column) / grid.columns;
      const double v = static_cast<double>(row) / grid.rows;
      const Vector3d right = f(u + kStep, v) - f(u - kStep, v);
      const Vector3d down = f(u, v + kStep) - f(u, v - kStep);
      add_vertex(shape, f(u, v), down.cross(right).normalized(),
                 Vector2d(u, v).cwiseProduct(grid.size));
    }
  }
  const int stride = grid.columns + 1;
  for (int row = 0; row < grid.rows; ++row) {
    for (int a = row * stride; a < row * stride + grid.columns; ++a) {
      add_cell(shape, a, a + 1, a + stride, a + stride + 1);
    }
  }
  return shape;
}

Shape painted(Shape shape, const Color& linear) {
  shape.colors.assign(shape.positions.size(), linear);
  return shape;
}

Shape stretched(Shape shape, const Vector3d& factors) {
  for (Vector3d& position : shape.positions) {
    position = position.cwiseProduct(factors);
  }
  for (Vector3d& normal : shape.normals) {
    normal = normal.cwiseQuotient(factors).normalized();
  }
  return shape;
}

void append(Shape& to, const Shape& shape, const Eigen::Isometry3d& T_to_shape) {
  const int first = static_cast<int>(to.positions.size());
  if (!to.colors.empty() || !shape.colors.empty()) {
    to.colors.resize(to.positions.size(), Color::Ones());
    to.colors.insert(to.colors.end(), shape.colors.begin(), shape.colors.end());
    to.colors.resize(to.positions.size() + shape.positions.size(), Color::Ones());
  }
  to.joints.insert(to.joints.end(), shape.joints.begin(), shape.joints.end());
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    add_vertex(to, T_to_shape * shape.positions[i], T_to_shape.linear() * shape.normals[i],
               shape.texcoords[i]);
  }
  for (const auto& [a, b, c] : shape.triangles) {
    to.triangles.push_back({first + a, first + b, first + c});
  }
}

Eigen::Isometry3d at(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

Eigen::Isometry3d about_x(double degrees) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(degrees * kPi / 180, Vector3d::UnitX()));
}

Eigen::Isometry3d about_y(double degrees) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(degrees * kPi / 180, Vector3d::UnitY()));
}

Eigen::Isometry3d about_z(double degrees) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(degrees * kPi / 180, Vector3d::UnitZ()));
}

}  // namespace scenes
