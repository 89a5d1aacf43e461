#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace scenes {

/// Returns the JSON indented by two spaces, with every value that holds no object on one line.
std::string json_text(const nlohmann::ordered_json& document);

}  // namespace scenes
