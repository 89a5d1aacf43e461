#include <Eigen/Geometry>

#include "synth/ray_tracing/color_tracer.h"
#include "synth/ray_tracing/color_tracer_step.h"
#include "synth/shading/glass.h"
#include "synth/shading/layers.h"

namespace synth {

/// Returns the body that a ray passes through before it meets a surface, null for air. Who looks at
/// the back of a solid is inside, whether or not the path entered there.
const Material* ColorTracer::medium_before(const PathLeg& leg, const Material& met,
                                           bool is_from_behind) const {
  const bool is_inside = is_from_behind && met.layers.is_solid && met.layers.transmission > 0;
  return mode_ == RenderMode::path && is_inside ? &met : leg.medium;
}

/// Returns the weight of a leg at the end of its ray, of which a body has absorbed its part.
Eigen::Vector3f ColorTracer::weight_at_end(const PathLegs& bundle, int lane,
                                           const Material* medium) {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  if (medium == nullptr) {
    return leg.weight;
  }
  const float length = bundle.rays.lanes.ray.tfar[lane] * bundle.rays.direction(lane).norm();
  return leg.weight.cwiseProduct(transmittance(medium->layers, length));
}

/// Makes a path meet one layer of a surface that has several. Returns whether this is glass.
bool ColorTracer::meet_layer(Arrival& arrival, const Step& step) const {
  const ChosenLayer chosen =
      choose_layer(arrival.material.layers.is_solid,
                   draw(step, arrival.leg, of_coverage_and_layer).y(), arrival.point);
  arrival.weight *= chosen.weight;
  return chosen.is_glass;
}

/// Adds the highlights of lamps on glass and continues the path. Nothing else draws its direction,
/// so that what it meets counts whole.
void ColorTracer::pass_glass(const Arrival& arrival, Step& step) const {
  const SurfacePoint& point = arrival.point;
  if (arrival.medium == nullptr) {
    Arrival gloss = arrival;
    gloss.point.base_color.setZero();
    gloss.point.metallic = 0;
    add_lit(gloss, false, step);
  }
  const Eigen::Vector2f choices = draw(step, arrival.leg, of_lobe_and_survival);
  const GlassScattered scattered =
      scatter_at_glass(point, arrival.material, choices.x(), draw(step, arrival.leg, of_direction));
  PathLeg next = leg_from(arrival);
  next.weight = next.weight.cwiseProduct(scattered.weight);
  next.density = 0;
  if (scattered.is_reflected) {
    if (!bounces_at(arrival.leg)) {
      return;
    }
    ++next.bounces;
  } else if (arrival.material.layers.is_solid) {
    next.medium = point.is_from_behind ? nullptr : &arrival.material;
  }
  go_on(next, choices.y(), ray_from(point, scattered.direction), step);
}

}  // namespace synth
