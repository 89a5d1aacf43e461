#include "synth/rendering/renderer.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "tests/support/error_text.h"

namespace synth {
namespace {

using support::error_text;
using testing::HasSubstr;

TEST(RenderOptions, SamplesAreRoundedUpToASquareGrid) {
  for (const auto& [samples, edge] :
       {std::pair{1, 1}, std::pair{2, 2}, std::pair{4, 2}, std::pair{8, 3}, std::pair{256, 16}}) {
    EXPECT_NO_THROW(RenderOptions{.samples = samples}.validate());
    EXPECT_EQ(RenderOptions{.samples = samples}.samples_per_edge(), edge);
  }
  for (const int samples : {-4, 0, 65537}) {
    EXPECT_THAT(error_text([&] { RenderOptions{.samples = samples}.validate(); }),
                HasSubstr("expected samples from 1 to 65536, got"));
  }
}

TEST(RenderOptions, AmbientMustNotBeNegative) {
  EXPECT_THAT(error_text([] { RenderOptions{.ambient = -0.1}.validate(); }),
              HasSubstr("expected ambient at or above 0, got -0.1"));
}

TEST(RenderOptions, DenoisingIsForPathsOfTheRayTracer) {
  const RenderOptions path{.mode = RenderMode::path, .denoise = true};
  EXPECT_NO_THROW(path.validate());
  for (const RenderMode mode : {RenderMode::direct, RenderMode::unlit, RenderMode::depth}) {
    EXPECT_THAT(error_text([&] { RenderOptions{.mode = mode, .denoise = true}.validate(); }),
                HasSubstr("denoise is for mode path of the ray tracer, got mode"));
  }
  RenderOptions raster = path;
  raster.kind = RendererKind::rasterizer;
  EXPECT_THAT(error_text([&] { raster.validate(); }), HasSubstr("of the rasterizer"));
  RenderOptions around{.mode = RenderMode::path, .denoise_frames = 2};
  EXPECT_THAT(error_text([&] { around.validate(); }), HasSubstr("denoise_frames 2 needs denoise"));
  around.denoise = true;
  EXPECT_NO_THROW(around.validate());
  around.denoise_frames = 9;
  EXPECT_THAT(error_text([&] { around.validate(); }), HasSubstr("from 0 to 8, got 9"));
  RenderOptions one = path;
  one.samples = 1;
  EXPECT_THAT(error_text([&] { one.validate(); }), HasSubstr("expected at least 2 of them, got 1"));
}

TEST(MakeRenderer, RefusesOptionsThatAreNotValid) {
  EXPECT_THROW(make_renderer(Scene{}, {.samples = 0}), vo::Error);
}

}  // namespace
}  // namespace synth
