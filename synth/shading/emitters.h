#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "synth/scene/world_geometry.h"
#include "synth/shading/drawn_light.h"
#include "synth/shading/surface.h"

namespace synth {

/// An EmitterDraw says where a point of an emitter is seen from, and by which random numbers it is
/// drawn.
struct EmitterDraw {
  Eigen::Vector3f from;  ///< m, start of the shadow ray, in the world-space geometry's coordinates
  float share = 0;       ///< WorldGeometry::share_at of the time
  float choice = 0;      ///< random in [0, 1), chooses the triangle
  Eigen::Vector2f square;  ///< random in [0, 1) x [0, 1), chooses its point
  float travelled = 0;     ///< m, path length from the camera to `from`
  float sample_width = 0;  ///< m, width of a sample's cone at 1 m
};

/// The triangles of a scene that shine by themselves, as lights to draw points from: a triangle
/// with a probability by its area and emission; then, if it is near, a direction evenly over the
/// solid angle that it covers, and otherwise a point evenly over its area. Both sides shine.
class Emitters {
 public:
  /// The world-space geometry must outlive the emitters.
  explicit Emitters(const WorldGeometry& world);

  bool empty() const { return triangles_.empty(); }

  /// Returns the light of a point drawn at random, which other surfaces may hide.
  DrawnLight draw(const EmitterDraw& draw) const;

  /// Returns the density, 1/sr, with which `draw` returns the direction of a ray of unit direction
  /// and of this length, m, that hits the triangle at `point`; zero if the triangle does not shine.
  float density(const SurfaceTriangle& triangle, std::size_t mesh, int index,
                const SurfacePoint& point, float distance) const;

 private:
  struct Triangle {
    int mesh;
    int index;
    float probability;
    double cumulative;  ///< sum of the probabilities up to this one
  };

  void add_mesh(int mesh);
  DrawnLight draw_towards(const SurfaceTriangle& triangle, const Triangle& chosen,
                          const EmitterDraw& draw) const;

  const WorldGeometry& world_;
  std::vector<Triangle> triangles_;
  std::vector<SurfaceTriangle> prepared_;  ///< of the triangles, at rest; none if they are many
  std::vector<std::ptrdiff_t> first_;  ///< per mesh, index of its first triangle; -1: none shines
};

}  // namespace synth
