#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "synth/gltf.h"

namespace synth {

/// Adds a note unless it is there already.
inline void add_note(Notes& notes, std::string note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) {
    notes.push_back(std::move(note));
  }
}

}  // namespace synth
