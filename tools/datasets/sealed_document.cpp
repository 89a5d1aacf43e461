#include "tools/datasets/sealed_document.h"

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/hashing/content_hash.h"
#include "vo/text_files/json_limits.h"

namespace tools {
namespace {

using SealedJson = nlohmann::ordered_json;

constexpr const char* kSeal = "hash";

std::string seal_of(const SealedJson& document) {
  return vo::content_hash(json_text(document, -1));
}

}  // namespace

std::string sealed_text(SealedJson document) {
  document[kSeal] = seal_of(document);
  return json_text(document, -1);
}

SealedJson read_document(const std::filesystem::path& file, const JsonSchema& schema) {
  const std::string text = vo::read_file(file, vo::kMaxDocumentBytes);
  vo::require_json_within_limits(text, file.string());
  SealedJson document = SealedJson::parse(text, nullptr, false);
  const std::string name = std::string("edvo.") + schema.name;
  vo::require(document.is_object() && document.value("schema", SealedJson()) == name, file.string(),
              ": is no JSON document of schema ", name);
  const SealedJson version = document.value("schema_version", SealedJson());
  vo::require(version == schema.version, file.string(), ": schema_version: got ", version.dump(),
              ", expected ", schema.version);
  return document;
}

bool has_seal(const SealedJson& document) {
  return document.contains(kSeal);
}

bool is_as_sealed(SealedJson document) {
  const SealedJson seal = document.value(kSeal, SealedJson());
  document.erase(kSeal);
  return seal == seal_of(document);
}

}  // namespace tools
