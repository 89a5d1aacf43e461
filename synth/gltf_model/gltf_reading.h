#pragma once

#include <cstddef>
#include <string>

#include "synth/gltf_document/notes.h"
#include "synth/gltf_model/gltf_model.h"
#include "vo/core/error.h"

namespace synth {

/// The memory that may still be allocated for a file's content, as few bytes can expand to many.
class MemoryBudget {
 public:
  /// Takes `bytes` from the budget. Throws vo::Error beginning with `place` if fewer are left.
  void take(std::size_t bytes, const std::string& place) {
    vo::require(bytes <= left_, place, ": needs ", bytes, " bytes of memory, expected at most ",
                left_, " of the ", kMostGltfBytes, " that a scene may have");
    left_ -= bytes;
  }

 private:
  std::size_t left_ = kMostGltfBytes;
};

/// The model, notes and memory budget that the readers of a glTF file's parts share.
struct GltfReading {
  const GltfModel& model;
  Notes& notes;
  MemoryBudget& budget;
};

}  // namespace synth
