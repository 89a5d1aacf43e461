#include "synth/gltf_document/check_image_based_lights.h"

#include <optional>
#include <vector>

#include "synth/gltf_document/check_nodes.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

void check_light(const JsonObject& light, std::size_t images) {
  constexpr std::size_t kFaces = 6;
  constexpr std::size_t kHarmonics = 9;  // of bands 0 to 2
  const double intensity = light.number("intensity").value_or(1);
  require(intensity >= 0, light.place(), ": intensity is ", intensity, ", expected 0 or more");
  require_unit_rotation(light.numbers("rotation", 4), light);
  light.required_whole_number("specularImageSize");
  require(!light.index_rows("specularImages", kFaces, images).empty(), light.place(),
          ": has no specularImages, expected the six faces of a cube map");
  const std::size_t rows = light.number_rows("irradianceCoefficients", 3).size();
  require(rows == 0 || rows == kHarmonics, light.place(), ": irradianceCoefficients has ", rows,
          " elements, expected ", kHarmonics);
}

}  // namespace

void check_image_based_lights(const JsonObject& root) {
  const std::optional<JsonObject> extension = root.extension(kImageBasedLightExtension);
  const std::vector<JsonObject> lights =
      extension ? extension->objects("lights") : std::vector<JsonObject>();
  const std::size_t images = root.objects("images").size();
  for (const JsonObject& light : lights) {
    check_light(light, images);
  }
  for (const JsonObject& scene : root.objects("scenes")) {
    if (const auto reference = scene.extension(kImageBasedLightExtension)) {
      reference->required_index("light", lights.size());
    }
  }
}

}  // namespace synth
