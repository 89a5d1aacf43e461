#include "tools/make_scenes/gltf_writing/gltf_animations.h"

#include <cstddef>
#include <string>

namespace scenes {
namespace {

int write_times(Document& document, const std::vector<double>& times) {
  std::string& bytes = document.views[animation];
  const std::size_t offset = bytes.size();
  for (const double time : times) {
    write_float(bytes, time, kGrid);
  }
  return add_accessor(document, animation, offset, times.size(),
                      {{"componentType", kFloat},
                       {"type", "SCALAR"},
                       {"min", {snapped(times.front(), kGrid)}},
                       {"max", {snapped(times.back(), kGrid)}}});
}

int write_translations(Document& document, const Motion& motion) {
  std::string& bytes = document.views[animation];
  const std::size_t offset = bytes.size();
  for (const Eigen::Isometry3d& T_parent_node : motion.T_parent_node) {
    for (const double x : T_parent_node.translation()) {
      write_float(bytes, x, kGrid);
    }
  }
  return add_accessor(document, animation, offset, motion.times.size(),
                      {{"componentType", kFloat}, {"type", "VEC3"}});
}

/// Writes quaternions x, y, z, w, each with the sign nearest to the one before, so that players
/// interpolate along the shorter arc. Returns the accessor.
int write_rotations(Document& document, const Motion& motion) {
  std::string& bytes = document.views[animation];
  const std::size_t offset = bytes.size();
  Eigen::Vector4d last = Eigen::Vector4d::UnitW();
  for (const Eigen::Isometry3d& T_parent_node : motion.T_parent_node) {
    const Eigen::Vector4d coefficients = Eigen::Quaterniond(T_parent_node.linear()).coeffs();
    last = last.dot(coefficients) < 0 ? Eigen::Vector4d(-coefficients) : coefficients;
    for (const double x : last) {
      write_float(bytes, x, kFineGrid);
    }
  }
  return add_accessor(document, animation, offset, motion.times.size(),
                      {{"componentType", kFloat}, {"type", "VEC4"}});
}

}  // namespace

void add_animations(Document& document, const Model& model) {
  if (model.motions.empty()) {
    return;
  }
  Json samplers;
  Json channels;
  for (const Motion& motion : model.motions) {
    const int times = write_times(document, motion.times);
    const auto add_channel = [&](const char* path, int values) {
      channels.push_back(
          {{"sampler", samplers.size()}, {"target", {{"node", motion.node}, {"path", path}}}});
      samplers.push_back({{"input", times}, {"interpolation", "LINEAR"}, {"output", values}});
    };
    add_channel("translation", write_translations(document, motion));
    add_channel("rotation", write_rotations(document, motion));
  }
  document.json["animations"].push_back(
      {{"name", model.name}, {"channels", channels}, {"samplers", samplers}});
}

}  // namespace scenes
