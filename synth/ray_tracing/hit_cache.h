#pragma once

#include "synth/scene/scene.h"

namespace synth {

/// Remembers what was made of the triangle that was hit last, as neighbouring rays tend to hit the
/// same one.
template <typename Made>
class HitCache {
 public:
  /// What `make(mesh, triangle)` gives.
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
