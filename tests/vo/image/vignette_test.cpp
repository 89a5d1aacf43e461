#include "vo/image/vignette.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

vo::PinholeCamera camera() {
  return {.width = 40, .height = 30, .fx = 35, .fy = 35, .cx = 18, .cy = 16};
}

TEST(Vignette, LeavesThePrincipalPointAndBrightensByThePolynomial) {
  vo::GrayImage image(30, 40, 0.25F);
  take_out({{0.6, -0.1}}, camera(), {}, image);
  EXPECT_FLOAT_EQ(image(16, 18), 0.25F);
  const double rho2 = (10 * 10 + 5 * 5) / (25.0 * 25.0);
  EXPECT_NEAR(image(21, 28), 0.25 * (1 + 0.6 * rho2 - 0.1 * rho2 * rho2), 1e-6);
}

TEST(Vignette, IsTakenOutAfterAnotherAsFromTheStart) {
  const vo::Vignette first{{0.3, 0.1}};
  const vo::Vignette second{{0.5, -0.05}};
  vo::GrayImage at_once(30, 40, 0.5F);
  vo::GrayImage in_turn = at_once.clone();
  take_out(second, camera(), {}, at_once);
  take_out(first, camera(), {}, in_turn);
  take_out(second, camera(), first, in_turn);
  EXPECT_LT(cv::norm(at_once, in_turn, cv::NORM_INF), 1e-6);
}

/// The same light reaches the same place of a pyramid's every level.
TEST(Vignette, IsThatOfTheHalvedCamera) {
  const vo::PinholeCamera fine = camera();
  const vo::PinholeCamera coarse = fine.halved();
  const Eigen::Vector2d at_coarse = vo::VignetteTerms(coarse).at(5, 7);
  const Eigen::Vector2d at_fine = vo::VignetteTerms(fine).at(2 * 5 + 0.5, 2 * 7 + 0.5);
  EXPECT_LT((at_coarse - at_fine).norm(), 1e-12);
}

}  // namespace
