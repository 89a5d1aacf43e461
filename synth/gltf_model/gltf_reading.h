#pragma once

#include <cstddef>
#include <string>

#include "synth/gltf_model/gltf_model.h"
#include "synth/gltf_model/notes.h"
#include "vo/core/error.h"

namespace synth {

/// What may still be allocated for what a file holds: a few bytes can promise much.
class MemoryBudget {
 public:
  /// Throws vo::Error beginning with `place` when more is asked for than is left.
  void take(std::size_t bytes, const std::string& place) {
    vo::require(bytes <= left_, place, ": needs ", bytes, " bytes of memory, expected at most ",
                left_, " of the ", kMostGltfBytes, " that a scene may have");
    left_ -= bytes;
  }

 private:
  std::size_t left_ = kMostGltfBytes;
};

/// What every reader of a part of a file works with.
struct GltfReading {
  const GltfModel& model;
  Notes& notes;
  MemoryBudget& budget;
};

}  // namespace synth
