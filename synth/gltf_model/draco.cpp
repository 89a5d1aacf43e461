#include "synth/gltf_model/draco.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include "synth/gltf_document/check_draco.h"
#include "synth/gltf_model/gltf_reading.h"
#include "synth/scene/scene.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

/// Bytes that decoding needs per triangle for its tables of corners, vertices and attributes.
constexpr std::size_t kBytesPerFace = 128;

struct Encoded {
  const char* data = nullptr;
  std::size_t size = 0;
};

/// Returns the triangle count that the stream's header states, before anything is allocated for it.
std::uint32_t face_count(const Encoded& encoded, const std::string& place) {
  draco::DecoderBuffer buffer;
  buffer.Init(encoded.data, encoded.size);
  draco::DracoHeader header{};
  require(draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok() &&
              header.encoder_type == draco::TRIANGULAR_MESH,
          place, ": is no mesh, expected data of KHR_draco_mesh_compression");
  require(header.version_major == 2 && header.version_minor == 2, place, ": is of version ",
          static_cast<int>(header.version_major), '.', static_cast<int>(header.version_minor),
          ", expected 2.2");
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
  draco::GeometryMetadata metadata;
  bool is_read = (header.flags & METADATA_FLAG_MASK) == 0 ||
                 draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata);
  std::uint32_t faces = 0;
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    std::uint8_t traversal = 0;
    std::uint32_t vertices = 0;
    is_read = is_read && buffer.Decode(&traversal) && draco::DecodeVarint(&vertices, &buffer);
  }
  std::uint32_t points = 0;
  is_read = is_read && draco::DecodeVarint(&faces, &buffer) &&
            (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING ||
             draco::DecodeVarint(&points, &buffer));
  require(is_read, place, ": ends in its header, expected undamaged data");
  require(points / 3 <= faces, place, ": has ", points, " points for ", faces,
          " triangles, expected at most three for each");
  return faces;
}

class DracoReader {
 public:
  DracoReader(const JsonObject& root, GltfModel& model)
      : model_(model), views_(root.objects("bufferViews")) {}

  void decode(tinygltf::Primitive& primitive, const JsonObject& source) {
    const auto extension = source.extension(kDracoExtension);
    if (!extension) {
      return;
    }
    const std::size_t view = extension->required_index("bufferView", views_.size());
    const draco::Mesh& mesh = mesh_of(view);
    require(mesh.num_faces() > 0, views_[view].place(), ": has no triangles, expected some");
    add_indices(mesh, primitive, source.place());
    const JsonObject attributes = extension->required_object("attributes");
    for (const std::string& name : attributes.keys()) {
      const std::size_t id = attributes.required_whole_number(name);
      const draco::PointAttribute* attribute =
          id > UINT32_MAX ? nullptr : mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
      require(attribute != nullptr, attributes.place(), ": ", name, " is attribute ", id,
              ", expected one that the compressed mesh has");
      int& accessor = primitive.attributes[name];
      accessor = add_attribute(mesh, *attribute, accessor, attributes.place() + ": " + name);
    }
  }

 private:
  const draco::Mesh& mesh_of(std::size_t view_index) {
    std::unique_ptr<draco::Mesh>& mesh = meshes_[view_index];
    if (mesh) {
      return *mesh;
    }
    const std::string place = views_[view_index].place();
    const tinygltf::BufferView& view = model_.content.bufferViews[view_index];
    const Bytes& bytes = model_.content.buffers[at(view.buffer)].data;
    require(!bytes.empty(), place, ": is in a buffer without data, expected compressed data");
    const Encoded encoded{reinterpret_cast<const char*>(bytes.data()) + view.byteOffset,
                          view.byteLength};
    budget_.take(face_count(encoded, place) * kBytesPerFace, place);
    draco::DecoderBuffer buffer;
    buffer.Init(encoded.data, encoded.size);
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    require(decoded.ok() && decoded.value() != nullptr, place,
            ": cannot be decoded: ", decoded.status().error_msg_string(),
            ", expected undamaged data of ", kDracoExtension);
    mesh = std::move(decoded).value();
    return *mesh;
  }

  void add_indices(const draco::Mesh& mesh, tinygltf::Primitive& primitive,
                   const std::string& place) {
    tinygltf::Buffer buffer;
    buffer.data.resize(std::size_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t));
    auto* out = buffer.data.data();
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
      for (const draco::PointIndex& corner : mesh.face(face)) {
        const std::uint32_t index = corner.value();
        out = std::copy_n(reinterpret_cast<const std::uint8_t*>(&index), sizeof(index), out);
      }
    }
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.count = std::size_t{mesh.num_faces()} * 3;
    if (primitive.indices != kNone) {
      const std::size_t stated = model_.content.accessors[at(primitive.indices)].count;
      require(accessor.count == stated || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP, place,
              ": decodes to ", accessor.count, " indices, expected the ", stated,
              " of its accessor");
    }
    primitive.indices = add_accessor(std::move(accessor), std::move(buffer));
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
  }

  int add_attribute(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int stated,
                    const std::string& place) {
    tinygltf::Accessor accessor = model_.content.accessors[at(stated)];
    require(accessor.count == mesh.num_points(), place, ": decodes to ", mesh.num_points(),
            " elements, expected the ", accessor.count, " of its accessor");
    const auto type = static_cast<std::uint32_t>(accessor.type);
    const int components = tinygltf::GetNumComponentsInType(type);
    require(components == attribute.num_components(), place, ": decodes to ",
            static_cast<int>(attribute.num_components()), " components, expected the ", components,
            " of its accessor");
    accessor.byteOffset = 0;
    accessor.sparse.isSparse = false;
    tinygltf::Buffer buffer;
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        buffer.data = values_of<std::int8_t>(mesh, attribute, place);
        break;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        buffer.data = values_of<std::uint8_t>(mesh, attribute, place);
        break;
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        buffer.data = values_of<std::int16_t>(mesh, attribute, place);
        break;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        buffer.data = values_of<std::uint16_t>(mesh, attribute, place);
        break;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        buffer.data = values_of<std::uint32_t>(mesh, attribute, place);
        break;
      default:
        buffer.data = values_of<float>(mesh, attribute, place);
        break;
    }
    return add_accessor(std::move(accessor), std::move(buffer));
  }

  template <typename Component>
  Bytes values_of(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                  const std::string& place) {
    const std::size_t size =
        static_cast<std::size_t>(attribute.num_components()) * sizeof(Component);
    budget_.take(size * mesh.num_points(), place);
    Bytes bytes(size * mesh.num_points());
    std::vector<Component> value(static_cast<std::size_t>(attribute.num_components()));
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
      require(attribute.ConvertValue<Component>(attribute.mapped_index(point), value.data()), place,
              ": element ", point.value(), " cannot be converted to its accessor's type");
      std::copy_n(reinterpret_cast<const std::uint8_t*>(value.data()), size,
                  bytes.data() + size * point.value());
    }
    return bytes;
  }

  int add_accessor(tinygltf::Accessor accessor, tinygltf::Buffer buffer) {
    tinygltf::BufferView view;
    view.buffer = static_cast<int>(model_.content.buffers.size());
    view.byteLength = buffer.data.size();
    accessor.bufferView = static_cast<int>(model_.content.bufferViews.size());
    model_.content.buffers.push_back(std::move(buffer));
    model_.content.bufferViews.push_back(std::move(view));
    model_.content.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.content.accessors.size()) - 1;
  }

  GltfModel& model_;
  std::vector<JsonObject> views_;
  MemoryBudget budget_;
  std::map<std::size_t, std::unique_ptr<draco::Mesh>> meshes_;  ///< decoded meshes by buffer view
};

}  // namespace

void decode_draco(const JsonObject& root, GltfModel& model) {
  DracoReader reader(root, model);
  const std::vector<JsonObject> meshes = root.objects("meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::vector<JsonObject> primitives = meshes[m].objects("primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      reader.decode(model.content.meshes[m].primitives[p], primitives[p]);
    }
  }
}

}  // namespace synth
