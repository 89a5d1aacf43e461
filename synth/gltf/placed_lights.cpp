#include "synth/gltf/placed_lights.h"

#include "synth/scene/placed.h"

namespace synth {

Light place_light(const tinygltf::Light& source, const Eigen::Affine3d& T_world_node,
                  double scale) {
  Light light;
  light.position = T_world_node.translation();
  if (!source.color.empty()) {
    light.intensity = Eigen::Map<const Eigen::Vector3d>(source.color.data()).cast<float>();
  }
  light.intensity *= static_cast<float>(source.intensity);
  if (source.range > 0) {
    light.range = scale * source.range;
  }
  if (source.type != "directional") {
    light.intensity *= static_cast<float>(scale * scale);
  }
  if (source.type == "point") {
    return light;
  }
  light.direction = light_direction_of(T_world_node);
  light.kind = source.type == "spot" ? LightKind::spot : LightKind::directional;
  light.inner_cone = source.spot.innerConeAngle;
  light.outer_cone = source.spot.outerConeAngle;
  return light;
}

SceneCamera place_camera(const tinygltf::Camera& source, const Eigen::Affine3d& T_world_node) {
  SceneCamera camera;
  camera.name = source.name;
  camera.T_world_camera = T_world_camera_of(T_world_node);
  if (source.type == "perspective") {
    camera.vertical_fov = source.perspective.yfov;
    camera.aspect_ratio = source.perspective.aspectRatio;
  }
  return camera;
}

}  // namespace synth
