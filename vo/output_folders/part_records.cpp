#include "vo/output_folders/part_records.h"

#include <algorithm>
#include <utility>

#include "vo/files/input.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecords = "edvo-done/";  // visible, so that `cp DIR.part/*` takes it along

}  // namespace

std::string part_record_name(const std::string& part) {
  return kRecords + part;
}

bool is_part_record(const std::string& name) {
  return name.starts_with(kRecords);
}

PartRecords::PartRecords(fs::path folder)
    : folder_(std::move(folder)), listed_(read_list(folder_)) {}

FileRecords PartRecords::of(const std::string& part, const std::vector<std::string>& files) const {
  const fs::path own = folder_ / part_record_name(part);
  FileRecords known = fs::is_regular_file(own) ? parse_records(read_file(own)) : FileRecords();
  FileRecords records;
  for (const std::string& file : files) {
    const auto found = known.find(file);
    const auto listed = listed_.find(file);
    if (found != known.end()) {
      records.insert(*found);
    } else if (listed != listed_.end() && !listed->second.hash.empty()) {
      records.insert(*listed);
    }
  }
  return records;
}

bool PartRecords::has(const std::string& part, const std::vector<std::string>& files) const {
  const FileRecords records = of(part, files);
  return records.size() == files.size() &&
         std::all_of(records.begin(), records.end(),
                     [&](const auto& r) { return has_size(folder_, r.first, r.second); });
}

}  // namespace vo
