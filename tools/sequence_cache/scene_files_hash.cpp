#include "tools/sequence_cache/scene_files_hash.h"

#include <filesystem>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "synth/gltf_document/gltf_file.h"
#include "synth/gltf_document/uri.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/hashing/content_hash.h"

namespace tools {
namespace {

/// Adds the hashes of the files that the elements of an array such as "buffers" refer to.
void add_named_files(const synth::GltfFile& file, const char* array, vo::ContentHash& hash) {
  const auto elements = file.json.find(array);
  if (elements == file.json.end() || !elements->is_array()) {
    return;
  }
  for (const nlohmann::json& element : *elements) {
    const auto uri = element.is_object() ? element.find("uri") : element.end();
    if (!element.is_object() || uri == element.end() || !uri->is_string() ||
        synth::is_data_uri(uri->get<std::string>())) {
      continue;
    }
    const std::string place = file.path.string() + ": " + array;
    const std::filesystem::path named =
        synth::resolve_uri(file.path.parent_path(), uri->get<std::string>(), place);
    std::error_code error;  // whether a file may be missing is for the reader of the scene to say
    hash.add(std::filesystem::exists(named, error) ? vo::content_hash(vo::read_file(named)) : "");
  }
}

}  // namespace

std::string scene_files_hash(const std::filesystem::path& gltf) {
  const synth::GltfFile file = synth::read_gltf_file(gltf);
  vo::ContentHash hash;
  hash.add(vo::content_hash(vo::read_file(gltf)));
  add_named_files(file, "buffers", hash);
  add_named_files(file, "images", hash);
  return hash.hex();
}

}  // namespace tools
