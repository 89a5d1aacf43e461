#pragma once

#include "synth/scene/scene.h"

namespace synth {

/// Caches a value that is computed from the triangle hit last, as neighbouring rays tend to hit one
/// triangle.
template <typename Made>
class HitCache {
 public:
  /// Returns `make(mesh, triangle)`, called only if the triangle differs from the last one.
  template <typename Make>
  const Made& get(int mesh, int triangle, const Make& make) {
    if (mesh != mesh_ || triangle != triangle_) {
      mesh_ = mesh;
      triangle_ = triangle;
      made_ = make(mesh, triangle);
    }
    return made_;
  }

 private:
  int mesh_ = kNone;
  int triangle_ = kNone;
  Made made_;
};

}  // namespace synth
