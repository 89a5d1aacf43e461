#include "synth/scene/scene_hash.h"

#include <array>
#include <vector>

#include "vo/hashing/content_hash.h"

namespace synth {
namespace {

template <typename Vector>
void add_vectors(vo::ContentHash& hash, const std::vector<Vector>& vectors) {
  hash.add_values(std::span(reinterpret_cast<const float*>(vectors.data()),
                            vectors.size() * static_cast<std::size_t>(Vector::SizeAtCompileTime)));
}

template <typename Matrix>
void add_matrix(vo::ContentHash& hash, const Matrix& matrix) {
  hash.add_values(std::span<const typename Matrix::Scalar>(
      matrix.data(), static_cast<std::size_t>(matrix.size())));
}

void add_numbers(vo::ContentHash& hash, std::initializer_list<int> numbers) {
  hash.add_values(std::span<const int>(numbers.begin(), numbers.size()));
}

void add(vo::ContentHash& hash, const Mesh& mesh) {
  add_vectors(hash, mesh.positions);
  add_vectors(hash, mesh.normals);
  add_vectors(hash, mesh.tangents);
  for (const std::vector<Eigen::Vector2f>& texcoords : mesh.texcoords) {
    add_vectors(hash, texcoords);
  }
  add_vectors(hash, mesh.colors);
  hash.add_values(std::span<const std::array<int, 3>>(mesh.triangles));
  add_numbers(hash, {mesh.material});
}

void add(vo::ContentHash& hash, const Instance& instance) {
  add_numbers(hash, {instance.mesh});
  add_matrix(hash, instance.T_world_mesh.matrix());
}

void add(vo::ContentHash& hash, const TextureSlot& slot) {
  add_numbers(hash, {slot.texture, slot.texcoord_set});
  add_matrix(hash, slot.T_image_texcoord.matrix());
}

/// Adds what most materials do not have, so that the hash of these does not depend on it.
void add_extension_maps(vo::ContentHash& hash, const Material& material) {
  const MaterialLayers& layers = material.layers;
  const std::array slots = {&material.specular_texture,          &material.specular_color_texture,
                            &layers.transmission_texture,        &layers.clearcoat_texture,
                            &layers.clearcoat_roughness_texture, &layers.clearcoat_normal_texture};
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i]->texture != kNone) {
      add_numbers(hash, {static_cast<int>(i)});
      add(hash, *slots[i]);
    }
  }
  if (layers.clearcoat_normal_scale != MaterialLayers().clearcoat_normal_scale) {
    hash.add_values(std::span<const float>(&layers.clearcoat_normal_scale, 1));
  }
  if (material.specular_color != Material().specular_color) {
    add_matrix(hash, material.specular_color);
  }
}

/// Adds what most materials do not have, so that the hash of these does not depend on it.
void add_layers(vo::ContentHash& hash, const Material& material) {
  const MaterialLayers& layers = material.layers;
  if (material.ior != Material().ior || layers.any()) {
    add_matrix(hash, layers.attenuation_color);
    const std::array factors = {material.ior, layers.transmission, layers.attenuation_distance,
                                layers.clearcoat, layers.clearcoat_roughness};
    hash.add_values(std::span<const float>(factors));
    add_numbers(hash, {static_cast<int>(layers.is_solid)});
  }
}

void add(vo::ContentHash& hash, const Material& material) {
  add_matrix(hash, material.base_color);
  add_matrix(hash, material.emission);
  const std::array factors = {material.metallic,           material.roughness,
                              material.specular,           material.normal_scale,
                              material.occlusion_strength, material.alpha_cutoff};
  hash.add_values(std::span<const float>(factors));
  add_numbers(hash, {static_cast<int>(material.alpha_mode), static_cast<int>(material.double_sided),
                     static_cast<int>(material.unlit)});
  for (const TextureSlot* slot :
       {&material.base_color_texture, &material.metallic_roughness_texture,
        &material.normal_texture, &material.occlusion_texture, &material.emissive_texture}) {
    add(hash, *slot);
  }
  add_layers(hash, material);
  add_extension_maps(hash, material);
}

void add(vo::ContentHash& hash, const Texture& texture) {
  add_numbers(hash, {texture.image, static_cast<int>(texture.wrap_u),
                     static_cast<int>(texture.wrap_v), static_cast<int>(texture.magnification),
                     static_cast<int>(texture.minification), static_cast<int>(texture.mip)});
}

void add(vo::ContentHash& hash, const TextureImage& image) {
  const cv::Mat_<cv::Vec4b>& pixels = image.levels.front();
  add_numbers(hash, {pixels.cols, pixels.rows, static_cast<int>(image.encoding)});
  for (int v = 0; v < pixels.rows; ++v) {
    hash.add({pixels.ptr<char>(v), static_cast<std::size_t>(pixels.cols) * pixels.elemSize()});
  }
}

void add(vo::ContentHash& hash, const Light& light) {
  add_numbers(hash, {static_cast<int>(light.kind)});
  add_matrix(hash, light.position);
  add_matrix(hash, light.direction);
  add_matrix(hash, light.intensity);
  const std::array shape = {light.range, light.inner_cone, light.outer_cone};
  hash.add_values(std::span<const double>(shape));
}

void add(vo::ContentHash& hash, const Environment& environment) {
  const cv::Mat_<cv::Vec3f>& pixels = environment.radiance;
  add_numbers(hash, {pixels.cols, pixels.rows});
  hash.add_values(std::span<const double>(&environment.turn, 1));
  for (int v = 0; v < pixels.rows; ++v) {
    hash.add({pixels.ptr<char>(v), static_cast<std::size_t>(pixels.cols) * pixels.elemSize()});
  }
}

void add(vo::ContentHash& hash, const MotionNode& node) {
  add_numbers(hash, {node.parent});
  add_matrix(hash, node.T_parent_node.matrix());
  add_matrix(hash, node.translation);
  add_matrix(hash, node.rotation.coeffs());
  add_matrix(hash, node.scale);
  hash.add_values(std::span<const float>(node.weights));
}

void add(vo::ContentHash& hash, const Animation& animation) {
  for (const AnimationChannel& channel : animation.channels) {
    add_numbers(hash, {channel.node, static_cast<int>(channel.property),
                       static_cast<int>(channel.curve.interpolation)});
    hash.add_values(std::span<const float>(channel.curve.times));
    hash.add_values(std::span<const float>(channel.curve.values));
  }
  for (const BrightnessChannel& channel : animation.brightness) {
    add_numbers(hash, {static_cast<int>(channel.factor), channel.target,
                       static_cast<int>(channel.curve.interpolation)});
    hash.add_values(std::span<const float>(channel.curve.times));
    hash.add_values(std::span<const float>(channel.curve.values));
  }
  const Animation at_once;
  if (animation.start != at_once.start || animation.stop != at_once.stop || animation.loops) {
    const std::array times = {animation.start, animation.stop};
    hash.add_values(std::span<const double>(times));
    add_numbers(hash, {static_cast<int>(animation.loops)});
  }
}

void add(vo::ContentHash& hash, const MeshShape& shape) {
  add_vectors(hash, shape.positions);
  add_vectors(hash, shape.normals);
  for (const MorphTarget& target : shape.targets) {
    add_vectors(hash, target.positions);
    add_vectors(hash, target.normals);
  }
  hash.add_values(std::span<const std::array<int, 4>>(shape.followed.joints));
  add_vectors(hash, shape.followed.weights);
}

void add(vo::ContentHash& hash, const Skin& skin) {
  hash.add_values(std::span<const int>(skin.joints));
  for (const Eigen::Affine3d& T_joint_mesh : skin.T_joint_mesh) {
    add_matrix(hash, T_joint_mesh.matrix());
  }
}

void add(vo::ContentHash& hash, const Brightness& brightness) {
  add_matrix(hash, brightness.color);
  hash.add_values(std::span<const float>(&brightness.strength, 1));
}

template <typename Element>
void add_all(vo::ContentHash& hash, const std::vector<Element>& elements) {
  for (const Element& element : elements) {
    add(hash, element);
  }
}

void add(vo::ContentHash& hash, const SceneMotion& motion) {
  add_all(hash, motion.nodes);
  add_all(hash, motion.animations);
  add_all(hash, motion.shapes);
  add_all(hash, motion.skins);
  hash.add_values(std::span<const int>(motion.instance_nodes));
  hash.add_values(std::span<const int>(motion.light_nodes));
  for (const DeformableMesh& deforming : motion.deforming) {
    add_numbers(hash, {deforming.instance, deforming.shape, deforming.node, deforming.skin});
  }
  add_numbers(hash, {static_cast<int>(motion.loop)});
  add_all(hash, motion.light_brightness);
  add_all(hash, motion.emission);
}

}  // namespace

std::string content_hash(const Scene& scene) {
  vo::ContentHash hash;
  add_all(hash, scene.meshes);
  add_all(hash, scene.instances);
  add_all(hash, scene.materials);
  add_all(hash, scene.textures);
  add_all(hash, scene.images);
  add_all(hash, scene.lights);
  add(hash, scene.motion);
  if (!scene.environment.empty()) {
    add(hash, scene.environment);
  }
  return hash.hex();
}

}  // namespace synth
