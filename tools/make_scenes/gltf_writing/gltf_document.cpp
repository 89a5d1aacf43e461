#include "tools/make_scenes/gltf_writing/gltf_document.h"

#include <algorithm>

namespace scenes {

void write_float(std::string& bytes, double value, double grid) {
  const auto number = static_cast<float>(snapped(value, grid));
  std::uint32_t bits = 0;
  static_assert(sizeof(bits) == sizeof(number));
  std::copy_n(reinterpret_cast<const char*>(&number), sizeof(bits), reinterpret_cast<char*>(&bits));
  write_little_endian(bytes, bits);
}

int add_accessor(Document& document, View view, std::size_t offset, std::size_t count,
                 const Json& format) {
  Json accessor = {{"bufferView", static_cast<int>(view)}, {"byteOffset", offset}};
  accessor.update(format);
  accessor["count"] = count;
  document.json["accessors"].push_back(accessor);
  return static_cast<int>(document.json["accessors"].size()) - 1;
}

std::string join_views(Document& document) {
  constexpr std::array<int, view_count> kStrides = {12, 12, 8, 4, 0, 0, 4, 4, 0};
  std::string binary;
  std::array<int, view_count> places{};
  int count = 0;
  for (std::size_t view = 0; view < view_count; ++view) {
    if (document.views.at(view).empty()) {
      continue;
    }
    places.at(view) = count++;
    binary.resize((binary.size() + 3) / 4 * 4);
    Json json = {{"buffer", 0},
                 {"byteOffset", binary.size()},
                 {"byteLength", document.views.at(view).size()}};
    if (kStrides.at(view) > 0) {
      json["byteStride"] = kStrides.at(view);
    }
    if (view != animation && view != binds) {
      json["target"] = view == indices ? 34963 : 34962;
    }
    document.json["bufferViews"].push_back(json);
    binary += document.views.at(view);
  }
  for (Json& accessor : document.json["accessors"]) {
    accessor["bufferView"] = places.at(accessor["bufferView"].get<std::size_t>());
  }
  return binary;
}

}  // namespace scenes
