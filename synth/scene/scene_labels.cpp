#include "synth/scene/scene_labels.h"

namespace synth {

std::string node_name(const FileLabels& file, int node) {
  const std::string& name = file.nodes[at(node)].name;
  return name.empty() ? std::to_string(node) : name;
}

std::string node_path(const FileLabels& file, int node) {
  std::vector<std::string> names;
  for (int step = node; step != kNone; step = file.nodes[at(step)].parent) {
    names.push_back(node_name(file, step));
  }
  std::string path = names.back();
  for (auto name = names.rbegin() + 1; name != names.rend(); ++name) {
    path += '/';
    path += *name;
  }
  return path;
}

}  // namespace synth
