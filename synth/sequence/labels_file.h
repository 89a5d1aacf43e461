#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synth/gltf/scene_file.h"
#include "synth/truth/truth_channels.h"
#include "vo/files/output.h"

namespace synth {

/// Returns whether there are channels of ids, which truth/labels.json explains.
bool has_labels(const TruthOptions& options);

/// Returns truth/labels.json: of each id of an instance, a material and a class, what it is called
/// in the scene's file and where it stands there. Throws vo::Error if there are more than 16 bits
/// hold.
vo::NamedBytes labels_file(const SceneFile& scene, const TruthOptions& options);

/// Returns the class's id of each instance of the scene, 0 = none; nothing without the channel.
std::vector<std::uint16_t> instance_classes(const SceneFile& scene, const TruthOptions& options);

/// Returns a sentence for each pattern of a class that matches nothing in the scene; none where the
/// channels have no ids.
std::vector<std::string> notes_on_classes(const SceneFile& scene, const TruthOptions& options);

}  // namespace synth
