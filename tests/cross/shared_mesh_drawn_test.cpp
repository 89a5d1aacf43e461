#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/rendering/renderer.h"
#include "tests/support/copied_meshes.h"

namespace synth {
namespace {

TEST(SharedMesh, IsDrawnAsMeshesOfTheirOwnAre) {
  const Scene scene = copies();
  const Scene separate = apart(scene);
  const RenderOptions options{.kind = RendererKind::rasterizer, .samples = 1};
  const Capture capture = all_of(still(camera(), {}));
  const RenderedFrame frame = make_renderer(scene, options)->render(capture);
  constexpr float kDrawn = 1e-5F;  // OpenGL's depth is single precision throughout
  expect_same(frame, make_renderer(separate, options)->render(capture), kDrawn);
}

}  // namespace
}  // namespace synth
