#pragma once

#include <tuple>

#include <gmock/gmock.h>

#include "synth/gltf/gltf.h"
#include "tests/support/gltf_document.h"
#include "tests/support/temp_folder.h"

namespace synth {

/// Two positions are at most `tolerance`, m, apart.
MATCHER_P(IsClose, tolerance, "") {
  return (std::get<0>(arg) - std::get<1>(arg)).norm() <= tolerance;
}

/// The scene that a document holds.
inline Scene load(const GltfDocument& document, const GltfOptions& options = {},
                  Notes* notes = nullptr) {
  const support::TempFolder folder;
  return load_gltf(document.write(folder), options, notes);
}

}  // namespace synth
