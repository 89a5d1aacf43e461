#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace scenes {

/// The document for people: indented by two, but what holds no object in a line of its own.
std::string json_text(const nlohmann::ordered_json& document);

}  // namespace scenes
