#include "tools/make_scenes/gltf_writing/json_text.h"

#include <algorithm>

namespace scenes {
namespace {

using Json = nlohmann::ordered_json;

bool is_flat(const Json& value) {
  return std::none_of(value.begin(), value.end(), [](const Json& element) {
    return element.is_object() ||
           (element.is_array() && std::any_of(element.begin(), element.end(),
                                              [](const Json& e) { return e.is_structured(); }));
  });
}

std::string text(const Json& value, const std::string& margin) {
  if (!value.is_structured() || is_flat(value)) {
    return value.dump();
  }
  const std::string inner = margin + "  ";
  std::string lines;
  for (const auto& [key, element] : value.items()) {
    const std::string name = value.is_object() ? Json(key).dump() + ": " : "";
    lines.append(lines.empty() ? "\n" : ",\n").append(inner).append(name);
    lines.append(text(element, inner));
  }
  return (value.is_object() ? "{" : "[") + lines + "\n" + margin + (value.is_object() ? "}" : "]");
}

}  // namespace

std::string json_text(const Json& document) {
  return text(document, "") + "\n";
}

}  // namespace scenes
