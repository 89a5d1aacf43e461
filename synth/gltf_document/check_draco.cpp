#include "synth/gltf_document/check_draco.h"

#include <string>

#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

void check_primitive(const JsonObject& primitive, std::size_t views) {
  const auto extension = primitive.extension(kDracoExtension);
  if (!extension) {
    return;
  }
  extension->required_index("bufferView", views);
  const std::size_t mode = primitive.whole_number("mode").value_or(4);
  require(mode == 4 || mode == 5, primitive.place(), ": mode is ", mode,
          ", expected 4 or 5, as its triangles are compressed");
  const JsonObject attributes = primitive.required_object("attributes");
  const JsonObject compressed = extension->required_object("attributes");
  for (const std::string& name : compressed.keys()) {
    compressed.required_whole_number(name);
    require(attributes.has(name), compressed.place(), ": has ", name,
            ", expected an attribute of the primitive");
  }
}

}  // namespace

void check_draco(const JsonObject& root) {
  const std::size_t views = root.objects("bufferViews").size();
  for (const JsonObject& mesh : root.objects("meshes")) {
    for (const JsonObject& primitive : mesh.objects("primitives")) {
      check_primitive(primitive, views);
    }
  }
}

}  // namespace synth
