#include "synth/truth/surface_classes.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string_view>

#include "synth/truth/name_pattern.h"
#include "vo/core/error.h"

namespace synth {
namespace {

/// A pattern of a class, and whether a name has matched it.
struct Pattern {
  std::string text;
  std::string_view kind;  ///< what it matches, "node" or "material"
  std::size_t place = 0;  ///< index of its class in the list of classes
  bool has_matched = false;
};

/// The patterns of all classes that are of one kind.
class Patterns {
 public:
  Patterns(std::string_view kind, const std::vector<SurfaceClass>& classes,
           std::vector<std::string> SurfaceClass::*texts)
      : none_(classes.size()) {
    for (std::size_t i = 0; i < classes.size(); ++i) {
      for (const std::string& text : classes[i].*texts) {
        patterns_.push_back({text, kind, i});
      }
    }
  }

  /// Returns the index of the first class of which a pattern matches one of the names; the number
  /// of classes if there is none.
  std::size_t first_match(std::initializer_list<std::string_view> names) {
    std::size_t first = none_;
    for (Pattern& pattern : patterns_) {
      if (std::any_of(names.begin(), names.end(),
                      [&](std::string_view name) { return matches(pattern.text, name); })) {
        pattern.has_matched = true;
        first = std::min(first, pattern.place);
      }
    }
    return first;
  }

  void list_unmatched(const std::vector<SurfaceClass>& classes,
                      std::vector<std::string>& sentences) const {
    for (const Pattern& pattern : patterns_) {
      if (!pattern.has_matched) {
        sentences.push_back(vo::concat("class ", classes[pattern.place].name, ": no ", pattern.kind,
                                       " that is shown matches \"", pattern.text, "\""));
      }
    }
  }

 private:
  std::vector<Pattern> patterns_;
  std::size_t none_;
};

/// Returns the id of each class of the list, and 0 behind the last for none.
std::vector<std::uint16_t> ids_in_list(const std::vector<SurfaceClass>& classes) {
  const std::vector<std::string> names = class_names(classes);
  constexpr std::size_t kMax = std::numeric_limits<std::uint16_t>::max();
  vo::require(names.size() <= kMax, "class: there are ", names.size(), ", expected at most ", kMax,
              " for 16-bit ids");
  std::vector<std::uint16_t> ids;
  for (const SurfaceClass& one : classes) {
    const auto name = std::find(names.begin(), names.end(), one.name);
    ids.push_back(static_cast<std::uint16_t>(name - names.begin() + 1));
  }
  ids.push_back(0);
  return ids;
}

}  // namespace

void SurfaceClass::validate() const {
  vo::require(!name.empty(), "class: expected a name");
  vo::require(!nodes.empty() || !materials.empty(), "class ", name,
              ": expected patterns of nodes or materials");
}

std::vector<std::string> class_names(const std::vector<SurfaceClass>& classes) {
  std::vector<std::string> names;
  for (const SurfaceClass& one : classes) {
    if (std::find(names.begin(), names.end(), one.name) == names.end()) {
      names.push_back(one.name);
    }
  }
  return names;
}

ClassIds class_ids(const Scene& scene, const SceneLabels& labels,
                   const std::vector<SurfaceClass>& classes) {
  const std::vector<std::uint16_t> ids = ids_in_list(classes);
  Patterns of_nodes("node", classes, &SurfaceClass::nodes);
  Patterns of_materials("material", classes, &SurfaceClass::materials);
  std::vector<std::size_t> by_material;
  for (const Material& material : scene.materials) {
    by_material.push_back(of_materials.first_match({material.name}));
  }
  const std::size_t unknown = classes.size() + 1;
  std::vector<std::vector<std::size_t>> by_node;  // of each file
  for (const FileLabels& file : labels.files) {
    by_node.emplace_back(file.nodes.size(), unknown);
  }
  ClassIds found;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const InstanceLabel& label = labels.instances[i];
    std::size_t& place = by_node[at(label.file)][at(label.node)];
    if (place == unknown) {
      const FileLabels& file = labels.files[at(label.file)];
      place = of_nodes.first_match({node_name(file, label.node), node_path(file, label.node)});
    }
    const int material = scene.meshes[at(scene.instances[i].mesh)].material;
    found.instances.push_back(
        ids[material == kNone ? place : std::min(place, by_material[at(material)])]);
  }
  for (const std::size_t place : by_material) {
    found.materials.push_back(ids[place]);
  }
  of_nodes.list_unmatched(classes, found.unmatched);
  of_materials.list_unmatched(classes, found.unmatched);
  return found;
}

}  // namespace synth
