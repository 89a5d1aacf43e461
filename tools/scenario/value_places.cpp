#include "tools/scenario/value_places.h"

#include <algorithm>

namespace tools {

bool is_about(const std::string& message, const std::string& value_key) {
  const std::string key = message.substr(0, message.find(':'));
  return vo::concat(".", value_key, ".").find(vo::concat(".", key, ".")) != std::string::npos;
}

std::string place_of(const std::string& message, const std::vector<vo::TomlValue>& values,
                     const std::filesystem::path& file) {
  const auto value = std::find_if(values.rbegin(), values.rend(), [&](const vo::TomlValue& one) {
    return is_about(message, one.key);
  });
  return value == values.rend() ? file.string() : value->place;
}

}  // namespace tools
