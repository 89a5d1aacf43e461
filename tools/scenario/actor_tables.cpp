#include "tools/scenario/actor_tables.h"

#include "tools/scenario/table_array.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/input.h"

namespace tools {

namespace fs = std::filesystem;

std::vector<synth::ActorOptions> take_actors(std::vector<vo::TomlValue>& values,
                                             const fs::path& folder) {
  std::vector<synth::ActorOptions> actors;
  for (const TableOfArray& table : take_tables("actor", values)) {
    synth::ActorOptions& actor = actors.emplace_back();
    std::vector<vo::Field> fields = vo::fields_of(actor, table.prefix);
    vo::assign_fields(table.values, fields);
    try {
      actor.validate();
    } catch (const vo::Error& error) {
      vo::fail(table.values.front().place, ": ", error.what());
    }
    actor.file = (folder / actor.file).lexically_normal();
  }
  return actors;
}

std::vector<synth::ActorOptions> load_actors(const fs::path& file) {
  if (file.empty()) {
    return {};
  }
  std::vector<vo::TomlValue> values = vo::read_toml(file);
  std::vector<synth::ActorOptions> actors = take_actors(
      values, file == vo::kStdinPath ? fs::current_path() : fs::absolute(file).parent_path());
  require_only_tables("actor", !actors.empty(), values, file);
  return actors;
}

}  // namespace tools
