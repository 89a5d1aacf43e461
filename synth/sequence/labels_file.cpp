#include "synth/sequence/labels_file.h"

#include <cstddef>

#include <nlohmann/json.hpp>

#include "synth/rendering/surface_ids.h"
#include "synth/truth/surface_classes.h"
#include "vo/core/error.h"
#include "vo/core/version.h"

namespace synth {
namespace {

using Json = nlohmann::ordered_json;

/// The limit of the bytes of truth/labels.json, as the paths of a file's nodes may be as long as it
/// is deep.
constexpr std::size_t kMostBytes = std::size_t{1} << 28U;

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json number_or_null(int index) {
  return index == kNone ? Json(nullptr) : Json(index);
}

/// JSON of members of which each is a value or a list with an element a line.
class LineDocument {
 public:
  explicit LineDocument(std::string place) : place_(std::move(place)) {}

  void add(const std::string& name, const Json& value) { begin(name) += text_of(value); }

  void begin_list(const std::string& name) {
    begin(name) += '[';
    separator_ = "\n    ";
  }

  void add_element(const Json& element) {
    text_ += separator_;
    text_ += text_of(element);
    separator_ = ",\n    ";
    vo::require(text_.size() <= kMostBytes, place_, ": the paths of its nodes have more than ",
                kMostBytes, " bytes in all, expected at most as many in truth/labels.json");
  }

  void end_list() { text_ += "\n  ]"; }

  std::string text() const { return text_ + "\n}\n"; }

 private:
  std::string& begin(const std::string& name) {
    text_ += vo::concat(text_.empty() ? "{\n  " : ",\n  ", text_of(name), ": ");
    return text_;
  }

  std::string place_;
  std::string text_;
  std::string separator_;
};

/// A scene with the classes of its surfaces.
struct ClassedScene {
  const Scene& scene;
  const SceneLabels& labels;
  ClassIds classes;
};

ClassedScene classed(const SceneFile& file, const TruthOptions& options) {
  return {file.scene(), file.labels(), class_ids(file.scene(), file.labels(), options.classes)};
}

/// Returns the id of a mesh's material.
std::size_t material_id(const Scene& scene, const Mesh& mesh) {
  return 1 + (mesh.material == kNone ? scene.materials.size() : at(mesh.material));
}

void add_instances(const ClassedScene& classed, LineDocument& document) {
  const Scene& scene = classed.scene;
  document.begin_list("instances");
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const InstanceLabel& label = classed.labels.instances[i];
    const FileLabels& file = classed.labels.files[at(label.file)];
    document.add_element(
        {{"id", i + 1},
         {"file", label.file},
         {"path", node_path(file, label.node)},
         {"node", label.node},
         {"copy", number_or_null(label.copy)},
         {"mesh", label.mesh},
         {"mesh_name", file.meshes[at(label.mesh)]},
         {"primitive", label.primitive},
         {"material_id", material_id(scene, scene.meshes[at(scene.instances[i].mesh)])},
         {"class_id", classed.classes.instances[i]}});
  }
  document.end_list();
}

void add_materials(const ClassedScene& classed, LineDocument& document) {
  const std::vector<Material>& materials = classed.scene.materials;
  document.begin_list("materials");
  for (std::size_t i = 0; i < materials.size(); ++i) {
    document.add_element({{"id", i + 1},
                          {"file", classed.labels.materials[i].file},
                          {"material", classed.labels.materials[i].index},
                          {"name", materials[i].name},
                          {"class_id", classed.classes.materials[i]}});
  }
  document.add_element({{"id", materials.size() + 1},
                        {"file", nullptr},
                        {"material", nullptr},
                        {"name", ""},
                        {"class_id", 0}});
  document.end_list();
}

void add_classes(const std::vector<SurfaceClass>& classes, LineDocument& document) {
  const std::vector<std::string> names = class_names(classes);
  if (names.empty()) {
    document.add("classes", Json::array());
    return;
  }
  document.begin_list("classes");
  for (std::size_t i = 0; i < names.size(); ++i) {
    document.add_element({{"id", i + 1}, {"name", names[i]}});
  }
  document.end_list();
}

}  // namespace

bool has_labels(const TruthOptions& options) {
  return options.has(TruthChannel::instance) || options.has(TruthChannel::material) ||
         options.has(TruthChannel::surface_class);
}

vo::NamedBytes labels_file(const SceneFile& scene, const TruthOptions& options) {
  require_16_bit_ids(scene.scene());
  const ClassedScene all = classed(scene, options);
  LineDocument document(scene.path().string());
  document.add("schema", "edvo.labels");
  document.add("schema_version", 1);
  document.add("edvo", vo::version());
  Json files = Json::array();
  for (const FileLabels& file : all.labels.files) {
    files.push_back(file.name);
  }
  document.add("files", files);
  add_classes(options.classes, document);
  add_materials(all, document);
  add_instances(all, document);
  return {"truth/labels.json", document.text()};
}

std::vector<std::uint16_t> instance_classes(const SceneFile& scene, const TruthOptions& options) {
  if (!options.has(TruthChannel::surface_class)) {
    return {};
  }
  require_16_bit_ids(scene.scene());
  return classed(scene, options).classes.instances;
}

std::vector<std::string> notes_on_classes(const SceneFile& scene, const TruthOptions& options) {
  return has_labels(options) ? classed(scene, options).classes.unmatched
                             : std::vector<std::string>();
}

}  // namespace synth
