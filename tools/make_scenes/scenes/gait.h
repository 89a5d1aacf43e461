#pragma once

namespace scenes {

// How a person walks, by the phase of two steps, rad. `side` is 1 on the left and -1 on the right.
inline constexpr double kTwoSteps = 1.2;      ///< m
inline constexpr double kHipSwing = 22;       ///< deg
inline constexpr double kKneeSwing = 48;      ///< deg
inline constexpr double kShoulderSwing = 26;  ///< deg
inline constexpr double kBob = 0.02;          ///< m that the hips are lower when the feet are apart

}  // namespace scenes
