#pragma once

#include <optional>

#include <Eigen/Core>

#include "synth/scene/scene.h"
#include "synth/shading/surface.h"

namespace synth {

/// Returns the share of unpolarised light that the boundary of two transparent media reflects, by
/// Fresnel's equations; 1 in total internal reflection. `cosine`, 0 to 1, is that of the angle to
/// the normal on the side of the ray, `ratio` the index of refraction behind the boundary over that
/// before it.
float fresnel_reflectance(float cosine, float ratio);

/// Returns the index of refraction behind a point of glass over that before it, as its viewer sees
/// it: solids are left from behind, thin walls met from the air on either side. Infinite behind a
/// solid of the index 0, which reflects all light.
float index_ratio(const SurfacePoint& point, const Material& material);

/// Returns the share of light that glass reflects: fresnel_reflectance times the factor of
/// KHR_materials_specular, but all where none can pass, as with an index of refraction of 0.
float glass_reflectance(const SurfacePoint& point, const Material& material, float cosine,
                        float ratio);

/// Returns the unit direction in which a ray towards a boundary goes on behind it, by Snell's law;
/// nothing in total internal reflection. `to_viewer` is unit, against the ray, and on the side of
/// the unit `normal`; `ratio` as in fresnel_reflectance.
std::optional<Eigen::Vector3f> refracted(const Eigen::Vector3f& to_viewer,
                                         const Eigen::Vector3f& normal, float ratio);

/// Returns the share of light, linear RGB, that a body of this material leaves over a length, m, by
/// Beer and Lambert's law: the attenuation colour to the power of the length in attenuation
/// distances.
Eigen::Vector3f transmittance(const MaterialLayers& layers, float length);

/// Returns whether the glass of a material shows things sharply, as it does up to a GGX alpha of
/// 0.001. Its roughness is the material's factor or, by a texture, less.
bool is_clear(float roughness);

/// Returns whether light goes straight on through a surface of this material wherever it meets it:
/// clear glass without a volume.
bool is_clear_wall(const Material& material);

/// Returns the share of light, linear RGB, that goes straight on through a point of a clear wall,
/// the mean of what `choose_layer` and `scatter_at_glass` do there.
Eigen::Vector3f straight_share(const SurfacePoint& point, const Material& material);

/// A GlassScattered says how a path goes on at glass.
struct GlassScattered {
  Eigen::Vector3f direction;  ///< unit
  Eigen::Vector3f weight;     ///< linear RGB; zero: no light comes
  bool is_reflected = false;
};

/// Returns a random direction at a surface that transmits all that it does not reflect: mirrored
/// or, with the rest of the probability, behind the surface and tinted by the base colour. There a
/// solid refracts it; a thin wall lets it go straight on. A rough surface has facets, drawn by
/// GGX's visible normals. `choice` and `square` are random in [0, 1).
GlassScattered scatter_at_glass(const SurfacePoint& point, const Material& material, float choice,
                                const Eigen::Vector2f& square);

}  // namespace synth
