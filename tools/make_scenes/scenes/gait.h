#pragma once

namespace scenes {

// A person, and how it walks, by the phase of two steps, rad. `side` is 1 on the left and -1 on the
// right.
inline constexpr double kHipHeight = 0.9;       ///< m
inline constexpr double kHipX = 0.09;           ///< m, of a hip from the middle
inline constexpr double kShoulderHeight = 1.4;  ///< m
inline constexpr double kTwoSteps = 1.2;        ///< m
inline constexpr double kHipSwing = 22;         ///< deg
inline constexpr double kKneeSwing = 48;        ///< deg
inline constexpr double kShoulderSwing = 26;    ///< deg
inline constexpr double kBob = 0.02;  ///< m that the hips are lower when the feet are apart

}  // namespace scenes
