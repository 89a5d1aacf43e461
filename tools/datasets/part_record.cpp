#include "tools/datasets/part_record.h"

#include <nlohmann/json.hpp>

#include "tools/datasets/layout.h"
#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/text_files/json_limits.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// Throws vo::Error naming the record unless a name is that of a file in the part's folder.
void require_name_in(const fs::path& part_folder, const std::string& name, const fs::path& record) {
  const fs::path path(name);
  vo::require(path.has_filename() && path != "." && path == path.lexically_normal(),
              record.string(), ": files: '", name, "' is no name of a file, expected one in ",
              part_folder.string());
  vo::path_in(part_folder, name, vo::concat(record.string(), ": files"));
}

}  // namespace

std::string format_part_record(const PartRecord& record) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const MadeFile& file : record.files) {
    files.push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  return json_text(json_document({"dataset_part"}, {{"part", record.part},
                                                    {"host", record.host},
                                                    {"processor_s", record.processor_s},
                                                    {"files", files}}),
                   -1);
}

PartRecord read_part_record(const fs::path& part_folder) {
  const fs::path file = part_folder / kPartRecord;
  const std::string text = vo::read_file(file, vo::kMaxDocumentBytes);
  vo::require_json_within_limits(text, file.string());
  PartRecord record;
  try {
    const nlohmann::json document = nlohmann::json::parse(text);
    document.at("part").get_to(record.part);
    document.at("host").get_to(record.host);
    document.at("processor_s").get_to(record.processor_s);
    for (const nlohmann::json& made : document.at("files")) {
      record.files.push_back({made.at("name"), made.at("bytes"), made.at("sha256")});
      require_name_in(part_folder, record.files.back().name, file);
    }
  } catch (const nlohmann::json::exception& error) {
    vo::fail(file.string(), ": no record of a part: ", error.what());
  }
  return record;
}

}  // namespace tools
