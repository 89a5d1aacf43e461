#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace synth {

/// Notes on what a Scene leaves out of its glTF file, and on what is read although glTF does not
/// allow it; one sentence each.
using Notes = std::vector<std::string>;

/// Adds a note unless it is there already.
inline void add_note(Notes& notes, std::string note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) {
    notes.push_back(std::move(note));
  }
}

}  // namespace synth
