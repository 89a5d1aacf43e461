#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synth/scene/scene.h"
#include "synth/scene/scene_labels.h"

namespace synth {

/// A class of surfaces, by patterns of names (see `matches`). A surface is of it if its node's name
/// or path matches one of `nodes`, or its material's name one of `materials`. Several of one name
/// are one class.
struct SurfaceClass {
  std::string name;
  std::vector<std::string> nodes, materials;

  void validate() const;  ///< throws vo::Error if it has no name or no pattern
};

/// Returns the names of the classes, each once, in the order of their ids, which count from 1.
std::vector<std::string> class_names(const std::vector<SurfaceClass>& classes);

/// The classes of a scene's surfaces, the first that match; id 0 = none.
struct ClassIds {
  std::vector<std::uint16_t> instances;  ///< of each of Scene::instances
  std::vector<std::uint16_t> materials;  ///< of each of Scene::materials, by its own name alone
  std::vector<std::string> unmatched;    ///< a sentence for each pattern that matches nothing
};

/// Throws vo::Error if there are more classes than 16-bit ids.
ClassIds class_ids(const Scene& scene, const SceneLabels& labels,
                   const std::vector<SurfaceClass>& classes);

}  // namespace synth
