#include "synth/shading/layers.h"

#include <algorithm>

#include "synth/shading/shading.h"

namespace synth {
namespace {

/// The least share of the paths that meet a coat: it reflects little, but that may be of a lamp.
constexpr float kLeastCoat = 0.25F;

void become_coat(SurfacePoint& point) {
  point.base_color.setZero();
  point.metallic = 0;
  point.specular = 1;
  point.normal_reflectance.setConstant(kGlassReflectance);
  point.roughness = point.clearcoat_roughness;
  point.normal = point.coat_normal;
}

}  // namespace

float coat_reflectance(float clearcoat, float cosine) {
  const float m = 1 - std::clamp(cosine, 0.0F, 1.0F);
  return clearcoat * (kGlassReflectance + (1 - kGlassReflectance) * m * m * m * m * m);
}

ChosenLayer choose_layer(bool is_solid, float choice, SurfacePoint& point) {
  ChosenLayer chosen;
  const bool is_inside = is_solid && point.is_from_behind;
  if (point.clearcoat > 0 && !is_inside) {
    const float reflected =
        coat_reflectance(point.clearcoat, point.coat_normal.dot(point.to_viewer));
    const float coats = std::max(kLeastCoat, reflected);
    if (choice < coats) {
      become_coat(point);
      chosen.weight = point.clearcoat / coats;
      return chosen;
    }
    chosen.weight = coats < 1 ? (1 - reflected) / (1 - coats) : 0;
    choice = coats < 1 ? (choice - coats) / (1 - coats) : 0;
  }
  const float glass = point.transmission * (1 - point.metallic);
  chosen.is_glass = choice < glass;
  if (!chosen.is_glass) {
    point.metallic = std::min(1.0F, point.metallic / (1 - glass));
  }
  return chosen;
}

}  // namespace synth
