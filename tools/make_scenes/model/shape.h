#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "tools/make_scenes/painting/texture_painter.h"

namespace scenes {

/// The joints of a skin that a vertex follows: indices into Skin::joints.
struct VertexJoints {
  int first = 0;
  int second = 0;
  double weight = 1;  ///< of the first, 0 to 1; the second has the rest
};

/// Triangles in metres, counter-clockwise seen from outside. Texture coordinates are metres on the
/// surface with v pointing down, unless a function says that they span 0..1.
struct Shape {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals;
  std::vector<Eigen::Vector2d> texcoords;
  std::vector<Color> colors;         ///< linear RGB per vertex; empty = white
  std::vector<VertexJoints> joints;  ///< per vertex; empty = no skin moves them
  std::vector<std::array<int, 3>> triangles;
};

/// Returns a box around the origin whose edges are bevelled by `bevel` m (0 = sharp), shaded round.
Shape box(const Eigen::Vector3d& size, double bevel = 0);

/// Returns a bevelled box with the texture's u along its longest side, as the grain of a plank.
Shape plank(const Eigen::Vector3d& size, double bevel = 0.003);

/// Returns a box around the origin whose edges and corners are parts of cylinders and spheres.
Shape soft_box(const Eigen::Vector3d& size, double radius, int segments = 3);

/// Returns the surface of revolution about y of a profile of (radius, y), given from the bottom up
/// the outside (and down the inside). A point given twice makes a sharp edge.
Shape lathe(const std::vector<Eigen::Vector2d>& profile, int segments = 24);

/// Returns a closed cylinder from y = 0 up.
Shape cylinder(double radius, double height, int segments = 16);

/// Returns a sphere around the origin; its texture coordinates span (2 pi r, pi r).
Shape sphere(double radius, int segments = 24);

/// Returns a rectangle given by its top left corner and its sides `right` and `down`. `origin` is
/// the texture coordinate of that corner.
Shape rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& right,
                const Eigen::Vector3d& down, const Eigen::Vector2d& origin = {0, 0});

/// Returns an upright rectangle around the origin facing +z; its texture coordinates span 0..1.
Shape panel(double width, double height);

/// Returns an upright disc around the origin facing +z; its texture coordinates span 0..1 over the
/// square around it.
Shape disc(double radius, int segments = 32);

/// Subdivision of a surface, and its size for the texture coordinates.
struct SheetGrid {
  int columns = 8;
  int rows = 8;
  Eigen::Vector2d size = {1, 1};
};

/// Returns the surface f(u, v), u and v in 0..1, seen with u to the right and v down.
Shape sheet(const std::function<Eigen::Vector3d(double u, double v)>& f, const SheetGrid& grid);

/// Returns the shape in one vertex colour (linear), which multiplies the material's.
Shape painted(Shape shape, const Color& linear);

/// Returns the shape with its x, y and z multiplied by `factors`; texture coordinates stay.
Shape stretched(Shape shape, const Eigen::Vector3d& factors);

/// Appends `shape`, rotated and moved by T_to_shape, to `to`.
void append(Shape& to, const Shape& shape, const Eigen::Isometry3d& T_to_shape);

Eigen::Isometry3d at(double x, double y, double z);
Eigen::Isometry3d about_x(double degrees);
Eigen::Isometry3d about_y(double degrees);
Eigen::Isometry3d about_z(double degrees);

}  // namespace scenes
