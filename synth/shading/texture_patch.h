#pragma once

#include <array>

#include <Eigen/Core>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"

namespace synth {

/// The section of a colour sample's cone with the triangle that it meets: an ellipse.
struct SampleFootprint {
  Eigen::Vector3f weights;  ///< barycentric coordinates of the middle
  float log2_width = 0;     ///< log2 of the longer diameter, m
  int anisotropy = 1;       ///< as RenderOptions::anisotropy; 1 needs no diameters
  /// Changes of the barycentric coordinates over the two diameters.
  std::array<Eigen::Vector3f, 2> diameters{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
};

/// A texture mapped onto one triangle.
struct TexturePatch {
  const Texture* texture = nullptr;     ///< null where the material's factor alone counts
  const TextureImage* image = nullptr;  ///< image of the texture
  std::array<Eigen::Vector2f, 3> uv;    ///< image coordinates at the triangle's corners
  float lod_at_1m = 0;                  ///< level of detail for a footprint of 1 m

  /// Returns the filtered linear RGBA; requires a texture. Without anisotropy the level of detail
  /// is that of the footprint's longer diameter in all directions; with it, the mean of samples
  /// along the longer diameter in the image, as many as it is longer than the other, at the level
  /// of their distance (EXT_texture_filter_anisotropic, with the true axes of the ellipse).
  Eigen::Vector4f color(const SampleFootprint& footprint) const;
};

/// Returns a texture mapped onto a triangle; none where the mesh has no coordinates for it.
/// `double_area` is twice the triangle's area, m^2.
TexturePatch texture_patch(const Scene& scene, const FlatMesh& mesh, const TextureSlot& slot,
                           const std::array<int, 3>& vertices, float double_area);

}  // namespace synth
