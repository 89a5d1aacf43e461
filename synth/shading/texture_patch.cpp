#include "synth/shading/texture_patch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "synth/scene/texture.h"

namespace synth {
namespace {

/// The axes of an ellipse in an image.
struct TexelEllipse {
  Eigen::Vector2f major;   ///< texels, the longer axis
  float major_length = 0;  ///< texels
  float minor_length = 0;  ///< texels
};

/// Returns the axes of the ellipse with these conjugate diameters, texels: the eigenvectors of the
/// sum of their outer products, whose eigenvalues are the axes' squares.
TexelEllipse ellipse_of(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  const float xx = a.x() * a.x() + b.x() * b.x();
  const float xy = a.x() * a.y() + b.x() * b.y();
  const float yy = a.y() * a.y() + b.y() * b.y();
  const float half_difference = 0.5F * (xx - yy);
  const float root = std::sqrt(half_difference * half_difference + xy * xy);
  const Eigen::Vector2f axis = half_difference >= 0 ? Eigen::Vector2f(half_difference + root, xy)
                                                    : Eigen::Vector2f(xy, root - half_difference);
  TexelEllipse ellipse;
  ellipse.major_length = std::sqrt(0.5F * (xx + yy) + root);
  ellipse.minor_length = std::sqrt(std::max(0.0F, 0.5F * (xx + yy) - root));
  const float length = axis.norm();
  ellipse.major = length > 0 ? Eigen::Vector2f(axis * (ellipse.major_length / length))
                             : Eigen::Vector2f(ellipse.major_length, 0);
  return ellipse;
}

/// Returns the least number of samples whose distance is no longer than the shorter axis.
int samples_along(const TexelEllipse& ellipse, int most) {
  const float ratio = ellipse.major_length / ellipse.minor_length;
  return ratio < static_cast<float>(most) ? std::max(1, static_cast<int>(std::ceil(ratio))) : most;
}

Eigen::Vector2f image_place(const std::array<Eigen::Vector2f, 3>& uv,
                            const Eigen::Vector3f& weights) {
  return uv[0] * weights[0] + uv[1] * weights[1] + uv[2] * weights[2];
}

Eigen::Vector4f mean_along(const TexturePatch& patch, const SampleFootprint& footprint) {
  const cv::Mat_<cv::Vec4b>& texels = patch.image->levels[0];
  const Eigen::Array2f size(static_cast<float>(texels.cols), static_cast<float>(texels.rows));
  const auto in_texels = [&](const Eigen::Vector3f& diameter) {
    return Eigen::Vector2f(image_place(patch.uv, diameter).array() * size);
  };
  const TexelEllipse ellipse =
      ellipse_of(in_texels(footprint.diameters[0]), in_texels(footprint.diameters[1]));
  const int count = samples_along(ellipse, footprint.anisotropy);
  const float lod = std::log2(ellipse.major_length / static_cast<float>(count));
  const Eigen::Vector2f middle = image_place(patch.uv, footprint.weights);
  const Eigen::Vector2f axis = ellipse.major.array() / size;
  Eigen::Vector4f sum = Eigen::Vector4f::Zero();
  for (int i = 0; i < count; ++i) {
    const float along = (static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F;
    sum += sample(*patch.image, *patch.texture, middle + along * axis, lod);
  }
  return sum / static_cast<float>(count);
}

}  // namespace

Eigen::Vector4f TexturePatch::color(const SampleFootprint& footprint) const {
  if (footprint.anisotropy > 1) {
    return mean_along(*this, footprint);
  }
  return sample(*image, *texture, image_place(uv, footprint.weights),
                lod_at_1m + footprint.log2_width);
}

/// Texels per metre are the root of the triangle's area in the image, texels^2, over its area in
/// the scene, m^2.
TexturePatch texture_patch(const Scene& scene, const FlatMesh& mesh, const TextureSlot& slot,
                           const std::array<int, 3>& vertices, float double_area) {
  TexturePatch patch;
  const auto& texcoords = mesh.mesh->texcoords[slot.texcoord_set];
  if (slot.texture == kNone || scene.textures[slot.texture].image == kNone || texcoords.empty()) {
    return patch;
  }
  patch.texture = &scene.textures[slot.texture];
  patch.image = &scene.images[patch.texture->image];
  for (std::size_t i = 0; i < 3; ++i) {
    patch.uv[i] = slot.T_image_texcoord * texcoords[vertices[i]];
  }
  const Eigen::Vector2f a = patch.uv[1] - patch.uv[0];
  const Eigen::Vector2f b = patch.uv[2] - patch.uv[0];
  const auto texels = static_cast<float>(patch.image->levels[0].total());
  patch.lod_at_1m =
      0.5F * std::log2(std::abs(a.x() * b.y() - a.y() * b.x()) * texels / double_area);
  return patch;
}

}  // namespace synth
