#include "synth/gltf/placed_lights.h"

#include "synth/scene/placed.h"

namespace synth {
namespace {

LightKind kind_of(const tinygltf::Light& source) {
  return source.type == "point"  ? LightKind::point
         : source.type == "spot" ? LightKind::spot
                                 : LightKind::directional;
}

Eigen::Vector3f color_of(const tinygltf::Light& source) {
  return source.color.empty()
             ? Eigen::Vector3f::Ones().eval()
             : Eigen::Map<const Eigen::Vector3d>(source.color.data()).cast<float>().eval();
}

}  // namespace

float intensity_unit(LightKind kind, double scale) {
  return kind == LightKind::directional ? 1 : static_cast<float>(scale * scale);
}

Brightness brightness_of(const tinygltf::Light& source, double scale) {
  return {color_of(source),
          static_cast<float>(source.intensity) * intensity_unit(kind_of(source), scale)};
}

Light place_light(const tinygltf::Light& source, const Eigen::Affine3d& T_world_node,
                  double scale) {
  Light light;
  light.kind = kind_of(source);
  light.position = T_world_node.translation();
  light.intensity =
      color_of(source) * static_cast<float>(source.intensity) * intensity_unit(light.kind, scale);
  if (source.range > 0) {
    light.range = scale * source.range;
  }
  if (light.kind == LightKind::point) {
    return light;
  }
  light.direction = light_direction_of(T_world_node);
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
