#include "synth/gltf_model/gltf_model.h"

#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "synth/gltf_document/check_buffers.h"
#include "synth/gltf_document/check_document.h"
#include "synth/gltf_document/check_meshopt.h"
#include "synth/gltf_document/json_object.h"
#include "synth/gltf_document/uri.h"
#include "synth/gltf_model/draco.h"
#include "synth/gltf_model/meshopt.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

Bytes read_embedded(const std::string& uri, std::size_t length, const std::string& place) {
  UriData data = decode_data_uri(uri, place);
  require(data.media_type.empty() || data.media_type == "application/octet-stream" ||
              data.media_type == "application/gltf-buffer",
          place, ": its data URI is of type ", data.media_type,
          ", expected application/octet-stream or application/gltf-buffer");
  require(data.bytes.size() >= length, place, ": its data URI holds ", data.bytes.size(),
          " bytes, expected ", length);
  data.bytes.resize(length);
  return std::move(data.bytes);
}

/// Returns a buffer's bytes; none for a buffer without data, which only extensions can fill.
Bytes read_buffer(const GltfFile& file, const JsonObject& buffer, bool is_first) {
  const std::size_t length = buffer.required_whole_number("byteLength");
  const std::optional<std::string> uri = buffer.text("uri");
  if (uri && is_data_uri(*uri)) {
    return read_embedded(*uri, length, buffer.place());
  }
  if (uri) {
    const auto path = resolve_uri(file.path.parent_path(), *uri, buffer.place());
    return read_file(path, length, buffer.place());
  }
  if (!file.is_glb || !is_first || is_meshopt_fallback(buffer)) {
    return {};
  }
  require(!file.binary.empty(), buffer.place(),
          ": has no uri, expected one or a binary chunk in the .glb");
  require(length <= file.binary.size(), buffer.place(), ": byteLength is ", length,
          ", expected at most the ", file.binary.size(), " bytes of the binary chunk");
  return {file.binary.begin(), file.binary.begin() + static_cast<std::ptrdiff_t>(length)};
}

std::vector<tinygltf::Buffer> read_buffers(const GltfFile& file, const JsonObject& root) {
  std::vector<tinygltf::Buffer> buffers;
  for (const JsonObject& object : root.objects("buffers")) {
    tinygltf::Buffer buffer;
    buffer.data = read_buffer(file, object, buffers.empty());
    buffers.push_back(std::move(buffer));
  }
  return buffers;
}

/// Returns the elements of an array of the document that name files which do not exist, by index.
std::map<int, MissingFile> missing_files(const GltfFile& file, const JsonObject& root,
                                         const std::string& array) {
  std::map<int, MissingFile> missing;
  const std::vector<JsonObject> objects = root.objects(array);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::optional<std::string> uri = objects[i].text("uri");
    if (!uri || is_data_uri(*uri)) {
      continue;
    }
    std::filesystem::path path = resolve_uri(file.path.parent_path(), *uri, objects[i].place());
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
      missing[static_cast<int>(i)] = {vo::concat(array, '[', i, ']'), std::move(path)};
    }
  }
  return missing;
}

[[noreturn]] void fail_for(const std::vector<MissingFile>& files, const std::string& place) {
  if (files.size() == 1) {
    vo::fail(place, ": ", files[0].element, ": ", files[0].path.string(),
             " does not exist, expected a file");
  }
  std::string names;
  for (const MissingFile& missing : files) {
    names += vo::concat(names.empty() ? "" : ", ", missing.element, ": ", missing.path.string());
  }
  vo::fail(place, ": ", files.size(),
           " files that it names do not exist, expected all of them: ", names);
}

/// Throws vo::Error that names all files that do not exist if there is a buffer's among them.
void require_buffers(const GltfFile& file, const JsonObject& root,
                     const std::map<int, MissingFile>& missing_images) {
  std::vector<MissingFile> missing;
  for (const auto& [index, buffer] : missing_files(file, root, "buffers")) {
    missing.push_back(buffer);
  }
  if (!missing.empty()) {
    for (const auto& [index, image] : missing_images) {
      missing.push_back(image);
    }
    fail_for(missing, root.place());
  }
}

/// Returns references to all images. Throws vo::Error for a uri that cannot be read, used or not,
/// unless its file is missing.
std::vector<tinygltf::Image> list_images(const GltfFile& file, const JsonObject& root,
                                         const GltfModel& model) {
  std::vector<tinygltf::Image> images;
  for (const JsonObject& object : root.objects("images")) {
    tinygltf::Image& image = images.emplace_back();
    image.uri = object.text("uri").value_or("");
    if (const auto view = object.index("bufferView", model.content.bufferViews.size())) {
      image.bufferView = static_cast<int>(*view);
    } else if (is_data_uri(image.uri)) {
      decode_data_uri(image.uri, object.place());
    } else if (model.missing_images.count(static_cast<int>(images.size()) - 1) == 0) {
      file_size(resolve_uri(file.path.parent_path(), image.uri, object.place()), object.place());
    }
  }
  return images;
}

/// Replaces accessors of types that tinygltf refuses by float scalars; nothing reads them.
void replace_unknown_accessors(nlohmann::json& document) {
  for (nlohmann::json& accessor : document["accessors"]) {
    if (!packed_stride(JsonObject(accessor, {}))) {
      accessor = {{"type", "SCALAR"}, {"componentType", 5126}, {"count", accessor["count"]}};
    }
  }
}

/// Removes the byteStrides that tinygltf refuses; check_document has found that they change
/// nothing.
void erase_needless_strides(nlohmann::json& document) {
  for (nlohmann::json& view : document["bufferViews"]) {
    const std::size_t stride = view.value("byteStride", std::size_t{0});
    if (stride > 252 || stride % 4 != 0) {
      view.erase("byteStride");
    }
  }
}

/// Gives animation channels that target no node, which tinygltf drops, a node that is none.
void state_missing_target_nodes(nlohmann::json& document) {
  for (nlohmann::json& animation : document["animations"]) {
    for (nlohmann::json& channel : animation["channels"]) {
      channel["target"].emplace("node", kNone);
    }
  }
}

/// Parses with tinygltf what needs no other file; it gets no functions to open one.
tinygltf::Model parse_structure(nlohmann::json document, const std::string& place) {
  for (const char* key : {"buffers", "images", "extras"}) {
    document.erase(key);
  }
  replace_unknown_accessors(document);
  erase_needless_strides(document);
  state_missing_target_nodes(document);
  for (nlohmann::json& mesh : document["meshes"]) {
    for (nlohmann::json& primitive : mesh["primitives"]) {
      primitive.erase("indices");  // tinygltf refuses accessors without a view as indices
    }
  }
  const std::string text = document.dump();
  document = nullptr;  // the parser makes a document of its own
  require(text.size() <= std::numeric_limits<unsigned>::max(), place, ": its JSON has ",
          text.size(), " bytes, expected at most 4 GB");
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({});
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const bool parsed = parser.LoadASCIIFromString(&model, &error, &warning, text.c_str(),
                                                 static_cast<unsigned>(text.size()), {});
  require(parsed, place, ": is not a usable glTF document: ", error.substr(0, error.find('\n')));
  return model;
}

void set_indices(const JsonObject& root, tinygltf::Model& model) {
  const std::size_t accessors = model.accessors.size();
  const std::vector<JsonObject> meshes = root.objects("meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::vector<JsonObject> primitives = meshes[m].objects("primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const auto indices = primitives[p].index("indices", accessors);
      model.meshes[m].primitives[p].indices = indices ? static_cast<int>(*indices) : -1;
    }
  }
}

}  // namespace

std::string GltfModel::place(const std::string& array, int index) const {
  return path.string() + ": " + array + '[' + std::to_string(index) + ']';
}

std::string GltfModel::image_place(int index) const {
  const std::string& uri = content.images[static_cast<std::size_t>(index)].uri;
  const std::string name = place("images", index);
  return uri.empty() || is_data_uri(uri) ? name : name + " (" + uri + ")";
}

GltfModel read_gltf_model(const GltfFile& file, Notes& notes) {
  check_document(file, notes);
  const JsonObject root(file.json, file.path.string());
  GltfModel model{.path = file.path,
                  .content = parse_structure(file.json, root.place()),
                  .missing_images = missing_files(file, root, "images")};
  set_indices(root, model.content);
  require_buffers(file, root, model.missing_images);
  model.content.buffers = read_buffers(file, root);
  model.content.images = list_images(file, root, model);
  decode_meshopt(root, model);
  decode_draco(root, model);
  return model;
}

void fail_for_missing_images(const GltfModel& model) {
  std::vector<MissingFile> missing;
  for (const auto& [index, image] : model.missing_images) {
    missing.push_back(image);
  }
  fail_for(missing, model.path.string());
}

Bytes read_encoded_image(const GltfModel& model, int image) {
  const tinygltf::Image& reference = model.content.images[static_cast<std::size_t>(image)];
  const std::string place = model.place("images", image);
  if (reference.bufferView >= 0) {
    const auto& view = model.content.bufferViews[static_cast<std::size_t>(reference.bufferView)];
    const Bytes& data = model.content.buffers[static_cast<std::size_t>(view.buffer)].data;
    require(!data.empty(), place, ": is in a buffer without uri, expected one with data");
    const auto begin = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
    return {begin, begin + static_cast<std::ptrdiff_t>(view.byteLength)};
  }
  if (is_data_uri(reference.uri)) {
    return decode_data_uri(reference.uri, place).bytes;
  }
  const auto path = resolve_uri(model.folder(), reference.uri, place);
  return read_file(path, file_size(path, place), place);
}

}  // namespace synth
