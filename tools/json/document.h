#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace tools {

/// The name and version of a JSON schema: docs/schemas/NAME.json describes the documents that have
/// `"schema": "edvo.NAME"`. The version grows when a member is removed, renamed or means something
/// else.
struct JsonSchema {
  const char* name;
  int version = 1;
};

/// Returns a document of a schema: `schema`, `schema_version` and the version of edvo, then the
/// members.
nlohmann::ordered_json json_document(const JsonSchema& schema,
                                     const nlohmann::ordered_json& members);

/// Returns a document as lines of text that end in a line feed. NaN and infinity become null, bytes
/// that are not UTF-8 become U+FFFD.
std::string json_text(const nlohmann::ordered_json& document, int indent = 2);

}  // namespace tools
