#pragma once

#include "synth/scene/scene.h"

namespace synth {

/// A clear sky by day.
struct SkyOptions {
  double sun_elevation = 0.7;  ///< rad above the horizon
  double turbidity = 3;        ///< of the air, over that of clean air: 2 is clear, 10 is hazy

  void validate() const;  ///< throws vo::Error if out of range
};

/// Returns the sky's light in cd/m^2, the sun towards -z, as an image of one pixel for each 0.7
/// degrees: the sky after Preetham, Shirley & Smits (A practical analytic model for daylight,
/// 1999); the sun in the pixel that it is seen in, its 128 klx dimmed by the air mass of Kasten &
/// Young (Revised optical air mass tables, 1989); below the horizon ground that reflects a fifth of
/// what reaches it.
Environment clear_sky(const SkyOptions& options);

}  // namespace synth
