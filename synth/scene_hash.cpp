#include "synth/scene_hash.h"

#include <array>
#include <vector>

#include "vo/core/hash.h"

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

void add(vo::ContentHash& hash, const TextureSlot& slot) {
  add_numbers(hash, {slot.texture, slot.texcoord_set});
  add_matrix(hash, slot.T_image_texcoord.matrix());
}

void add(vo::ContentHash& hash, const Material& material) {
  add_matrix(hash, material.base_color);
  add_matrix(hash, material.emission);
  const std::array factors = {material.metallic, material.roughness, material.normal_scale,
                              material.occlusion_strength, material.alpha_cutoff};
  hash.add_values(std::span<const float>(factors));
  add_numbers(hash, {static_cast<int>(material.alpha_mode), static_cast<int>(material.double_sided),
                     static_cast<int>(material.unlit)});
  for (const TextureSlot* slot :
       {&material.base_color_texture, &material.metallic_roughness_texture,
        &material.normal_texture, &material.occlusion_texture, &material.emissive_texture}) {
    add(hash, *slot);
  }
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

}  // namespace

std::uint64_t content_hash(const Scene& scene) {
  vo::ContentHash hash;
  for (const Mesh& mesh : scene.meshes) {
    add(hash, mesh);
  }
  for (const Instance& instance : scene.instances) {
    add_numbers(hash, {instance.mesh});
    add_matrix(hash, instance.T_world_mesh.matrix());
  }
  for (const Material& material : scene.materials) {
    add(hash, material);
  }
  for (const Texture& texture : scene.textures) {
    add(hash, texture);
  }
  for (const TextureImage& image : scene.images) {
    add(hash, image);
  }
  for (const Light& light : scene.lights) {
    add(hash, light);
  }
  return hash.value();
}

}  // namespace synth
