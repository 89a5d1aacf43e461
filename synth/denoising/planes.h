#pragma once

#include <array>
#include <cstddef>

#include <opencv2/core.hpp>

namespace synth {

using Plane = cv::Mat_<float>;

/// The images that light is fitted in, a plane for each number, all of one size.
struct LightPlanes {
  std::array<std::array<Plane, 3>, 2> light;  ///< of each half and channel
  std::array<Plane, 3> variance;              ///< of the light of a half, per channel
  std::array<Plane, 3> normal;
  std::array<Plane, 3> reflectance;
  Plane nearness;  ///< relative to the picture's nearest surface
};

}  // namespace synth
