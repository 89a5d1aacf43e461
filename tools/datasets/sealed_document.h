#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/json/document.h"

namespace tools {

/// Returns a document as a line of text, with `hash` behind its members: the ContentHash of the
/// line without it, by which a document that was edited is told from one as it was written.
std::string sealed_text(nlohmann::ordered_json document);

/// Reads a JSON document of a schema. Throws vo::Error naming the file where it is none, or one of
/// another schema or version.
nlohmann::ordered_json read_document(const std::filesystem::path& file, const JsonSchema& schema);

/// Returns whether a document has a hash, be it its own or not.
bool has_seal(const nlohmann::ordered_json& document);

/// Returns whether a document is as `sealed_text` wrote it.
bool is_as_sealed(nlohmann::ordered_json document);

}  // namespace tools
