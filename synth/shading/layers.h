#pragma once

#include "synth/shading/surface.h"

namespace synth {

/// Returns the share of light that a clear coat of this strength, 0 to 1, reflects at this cosine
/// to its normal, which is what the material below it does not receive or send:
/// KHR_materials_clearcoat's clearcoat times Schlick's reflectance of an index of refraction
/// of 1.5.
float coat_reflectance(float clearcoat, float cosine);

/// A ChosenLayer is the one layer of a surface that a path meets.
struct ChosenLayer {
  float weight = 1;       ///< the layer's share of the surface over the probability of its choice
  bool is_glass = false;  ///< all light that is not reflected is transmitted
};

/// Chooses one layer of a surface at random and makes `point` a point of this layer alone, so that
/// the mean over all choices, times their weights, is the surface: the coat, or below it glass or
/// what is opaque. The inside of a solid (MaterialLayers::is_solid) has no coat. `choice` is random
/// in [0, 1).
ChosenLayer choose_layer(bool is_solid, float choice, SurfacePoint& point);

}  // namespace synth
