#include "synth/gltf_model/meshopt.h"

#include <algorithm>
#include <string>
#include <vector>

#include <meshoptimizer.h>

#include "synth/gltf_document/check_meshopt.h"
#include "synth/gltf_model/gltf_reading.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

/// Decodes a compressed buffer view; returns 0 on success.
int decode(const MeshoptView& view, const std::uint8_t* data, Bytes& decoded) {
  if (view.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(decoded.data(), view.count, view.stride, data, view.length);
  }
  return view.mode == "TRIANGLES"
             ? meshopt_decodeIndexBuffer(decoded.data(), view.count, view.stride, data, view.length)
             : meshopt_decodeIndexSequence(decoded.data(), view.count, view.stride, data,
                                           view.length);
}

void apply_filter(const MeshoptView& view, Bytes& decoded) {
  if (view.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
  } else if (view.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
  } else if (view.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
  }
}

}  // namespace

void decode_meshopt(const JsonObject& root, GltfModel& model) {
  MemoryBudget budget;
  const std::vector<JsonObject> views = root.objects("bufferViews");
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto extension = views[i].extension(kMeshoptExtension);
    if (!extension) {
      continue;
    }
    const MeshoptView view = read_meshopt_view(*extension);
    const Bytes& source = model.content.buffers[view.buffer].data;
    require(view.offset + view.length <= source.size(), extension->place(),
            ": refers to a buffer without data, expected compressed data");
    budget.take(view.count * view.stride, views[i].place());
    tinygltf::Buffer decoded;
    decoded.data.resize(view.count * view.stride);
    require(decode(view, source.data() + view.offset, decoded.data) == 0, extension->place(),
            ": cannot be decoded, expected undamaged data of EXT_meshopt_compression");
    apply_filter(view, decoded.data);
    model.content.bufferViews[i].buffer = static_cast<int>(model.content.buffers.size());
    model.content.bufferViews[i].byteOffset = 0;
    model.content.buffers.push_back(std::move(decoded));
  }
}

}  // namespace synth
