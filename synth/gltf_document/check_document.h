#pragma once

#include "synth/gltf_document/gltf_file.h"
#include "synth/gltf_document/notes.h"

namespace synth {

/// Returns whether the loader supports a glTF extension.
bool is_supported_extension(const std::string& name);

/// Checks a glTF document's whole JSON: types, indices, sizes, URIs, the node graph and the
/// required extensions. After it every index is in range, every accessor lies in its buffer as
/// declared, every URI stays in the file's folder, and the nodes form trees. What glTF does not
/// allow but can be read in one way only is noted. Opens nothing. Throws vo::Error.
void check_document(const GltfFile& file, Notes& notes);

}  // namespace synth
