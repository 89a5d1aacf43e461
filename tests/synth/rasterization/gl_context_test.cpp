#include "synth/rasterization/gl_context.h"

#include <array>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "synth/rasterization/gl_functions.h"
#include "synth/rasterization/gl_target.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace synth {
namespace {

class GlBackEnds : public testing::TestWithParam<GlBackEnd> {};

TEST_P(GlBackEnds, GiveBackTheFloatsThatTheyWereFilledWith) {
  std::optional<GlContext> context;
  try {
    context.emplace(GetParam());
  } catch (const vo::Error& error) {
    GTEST_SKIP() << error.what();
  }
  const GlContext::Current current(*context);
  const GlFunctions gl([&](const char* name) { return context->find_function(name); });
  GlTarget target(gl);
  const cv::Size size(5, 3);
  target.bind(size);
  constexpr std::array<float, 4> kColor{0.1F, -2, 3000.5F, 1e-9F};
  gl.ClearBufferfv(GL_COLOR, 0, kColor.data());
  const cv::Mat_<cv::Vec4f>& read = target.read_color();
  ASSERT_EQ(read.size(), size);
  for (const cv::Vec4f& texel : read) {
    EXPECT_EQ(texel, cv::Vec4f(kColor.data()));
  }
}

// OSMesa is what the rasterizer's own tests draw with; alone, it leaks 608 bytes of its driver.
INSTANTIATE_TEST_SUITE_P(Surfaceless, GlBackEnds, testing::Values(GlBackEnd::egl),
                         [](const testing::TestParamInfo<GlBackEnd>& back_end) {
                           return std::string(vo::to_string(back_end.param));
                         });

}  // namespace
}  // namespace synth
