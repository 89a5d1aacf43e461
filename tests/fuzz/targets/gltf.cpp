// libFuzzer's target for the glTF loader: whatever the bytes are, load_gltf gives a scene or throws
// vo::Error. What the scene refers to is looked for in an empty folder.
#include "synth/gltf/gltf.h"

#include <cstdint>
#include <span>

#include "synth/scene/scene_motion.h"
#include "vo/core/error.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    synth::Notes notes;
    const synth::Scene scene =
        synth::parse_gltf(std::span(data, size), "nowhere/scene.gltf", {}, &notes);
    if (synth::moves(scene)) {
      synth::scene_at(scene, 0.5);
    }
  } catch (const vo::Error&) {
    return 0;
  }
  return 0;
}
