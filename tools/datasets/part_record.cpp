#include "tools/datasets/part_record.h"

#include "tools/datasets/layout.h"
#include "tools/datasets/sealed_document.h"
#include "vo/core/error.h"
#include "vo/files/input.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr JsonSchema kRecordSchema{"dataset_part"};

nlohmann::ordered_json files_json(const std::vector<MadeFile>& files) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MadeFile& file : files) {
    list.push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  return list;
}

/// Throws vo::Error naming the record unless a name is that of a file in the part's folder.
void require_name_in(const fs::path& part_folder, const std::string& name, const fs::path& record) {
  const fs::path path(name);
  vo::require(path.has_filename() && path != "." && path == path.lexically_normal(),
              record.string(), ": files: '", name, "' is no name of a file, expected one in ",
              part_folder.string());
  vo::path_in(part_folder, name, vo::concat(record.string(), ": files"));
}

std::vector<MadeFile> files_of(const nlohmann::ordered_json& list, const fs::path& part_folder) {
  std::vector<MadeFile> files;
  for (const nlohmann::ordered_json& made : list) {
    files.push_back({made.at("name"), made.at("bytes"), made.at("sha256")});
    require_name_in(part_folder, files.back().name, part_folder / kPartRecord);
  }
  return files;
}

}  // namespace

std::string format_part_record(const PartRecord& record) {
  return sealed_text(
      json_document(kRecordSchema, {{"part", record.part},
                                    {"plan", record.plan},
                                    {"host", record.host},
                                    {"processor_s", record.processor_s},
                                    {"files", files_json(record.files)},
                                    {"index_files", files_json(record.index_files)}}));
}

PartRecord read_part_record(const fs::path& part_folder) {
  const fs::path file = part_folder / kPartRecord;
  const nlohmann::ordered_json document = read_document(file, kRecordSchema);
  vo::require(is_as_sealed(document), file.string(),
              ": is not as it was written: its hash differs");
  PartRecord record;
  try {
    document.at("part").get_to(record.part);
    document.at("plan").get_to(record.plan);
    document.at("host").get_to(record.host);
    document.at("processor_s").get_to(record.processor_s);
    record.files = files_of(document.at("files"), part_folder);
    record.index_files = files_of(document.at("index_files"), part_folder);
  } catch (const nlohmann::json::exception& error) {
    vo::fail(file.string(), ": no record of a part: ", error.what());
  }
  return record;
}

}  // namespace tools
