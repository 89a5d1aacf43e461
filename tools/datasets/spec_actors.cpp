#include "tools/datasets/spec_actors.h"

#include <algorithm>
#include <utility>

#include "tools/datasets/name_list.h"
#include "tools/scenario/table_array.h"
#include "vo/core/error.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

void add_value(const TableOfArray& table, vo::TomlValue value, const fs::path& folder,
               SpecActor& actor) {
  const bool is_list = value.key == table.prefix + "scenes";
  const bool is_file = value.key == table.prefix + "file";
  vo::require(!is_list || value.type == vo::FieldType::text, value.place, ": ", value.key,
              ": expected a text in quotes");
  if (is_list) {
    actor.scenes = names_in(value.text);
    return;
  }
  if (is_file) {
    value.text = (folder / value.text).lexically_normal().string();
  }
  actor.values.push_back(std::move(value));
}

}  // namespace

bool SpecActor::goes_through(const std::string& scene) const {
  return scenes.empty() || std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
}

std::vector<SpecActor> take_spec_actors(std::vector<vo::TomlValue>& values, const fs::path& spec) {
  const fs::path folder = fs::absolute(spec).parent_path();
  std::vector<SpecActor> actors;
  for (const TableOfArray& table : take_tables("actor", values)) {
    SpecActor& actor = actors.emplace_back();
    actor.place = table.values.front().place;
    for (const vo::TomlValue& value : table.values) {
      add_value(table, value, folder, actor);
    }
    vo::require(!actor.values.empty(), actor.place, ": actor: expected a file");
  }
  return actors;
}

}  // namespace tools
