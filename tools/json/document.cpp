#include "tools/json/document.h"

#include "vo/core/version.h"

namespace tools {

using Json = nlohmann::ordered_json;

Json json_document(const JsonSchema& schema, const Json& members) {
  Json document = {{"schema", std::string("edvo.") + schema.name},
                   {"schema_version", schema.version},
                   {"edvo", vo::version()}};
  document.update(members);
  return document;
}

std::string json_text(const Json& document, int indent) {
  return document.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tools
