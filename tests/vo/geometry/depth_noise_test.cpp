#include "vo/geometry/depth_noise.h"

#include <cmath>

#include <gtest/gtest.h>

#include "vo/core/error.h"

namespace {

TEST(DepthNoise, SourcesAddInSquares) {
  const vo::DepthNoise noise{.constant = 3e-3, .linear = 2e-3, .quadratic = 1e-3};
  EXPECT_NEAR(noise.sigma(2), 1e-3 * std::sqrt(3.0 * 3 + 4 * 4 + 4 * 4), 1e-12);
}

TEST(DepthNoise, OfStructuredLightIsNguyensAndKhoshelhams) {
  for (double z = 0.4; z <= 3; z += 0.1) {
    const double nguyen = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    EXPECT_NEAR(vo::kStructuredLightNoise.sigma(z), nguyen, 0.09 * nguyen) << z << " m";
  }
  EXPECT_NEAR(vo::kStructuredLightNoise.sigma(5), 1.425e-3 * 25, 1e-4);
}

TEST(DepthNoise, ThatIsNotKnownIsThatOfStructuredLight) {
  EXPECT_EQ(vo::known_depth_noise({}).quadratic, vo::kStructuredLightNoise.quadratic);
  EXPECT_EQ(vo::known_depth_noise({.linear = 1e-3}).linear, 1e-3);
  EXPECT_EQ(vo::known_depth_noise({.linear = 1e-3}).constant, 0);
  EXPECT_THROW(vo::DepthNoise{.linear = -1e-3}.validate(), vo::Error);
}

}  // namespace
