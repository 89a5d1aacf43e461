#include "synth/scene_hash.h"

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
  add_vectors(hash, mesh.texcoords);
  add_vectors(hash, mesh.colors);
  hash.add_values(std::span<const std::array<int, 3>>(mesh.triangles));
  add_numbers(hash, {mesh.material});
}

void add(vo::ContentHash& hash, const Material& material) {
  add_matrix(hash, material.base_color);
  add_matrix(hash, material.emission);
  add_numbers(hash, {material.base_color_texture, static_cast<int>(material.unlit)});
}

void add(vo::ContentHash& hash, const Texture& texture) {
  add_numbers(hash, {texture.image, static_cast<int>(texture.wrap_u),
                     static_cast<int>(texture.wrap_v), static_cast<int>(texture.magnification),
                     static_cast<int>(texture.minification), static_cast<int>(texture.mip)});
}

void add(vo::ContentHash& hash, const TextureImage& image) {
  const cv::Mat_<cv::Vec4b>& pixels = image.levels.front();
  add_numbers(hash, {pixels.cols, pixels.rows});
  for (int v = 0; v < pixels.rows; ++v) {
    hash.add({pixels.ptr<char>(v), static_cast<std::size_t>(pixels.cols) * pixels.elemSize()});
  }
}

void add(vo::ContentHash& hash, const Light& light) {
  add_numbers(hash, {static_cast<int>(light.kind)});
  add_matrix(hash, light.position);
  add_matrix(hash, light.direction);
  add_matrix(hash, light.intensity);
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
