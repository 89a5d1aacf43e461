#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

#include "synth/rendering/capture.h"
#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace synth {

enum class RendererKind { ray_tracer, rasterizer };

constexpr auto enum_names(RendererKind) {
  return std::array{std::pair{RendererKind::ray_tracer, "ray_tracer"},
                    std::pair{RendererKind::rasterizer, "rasterizer"}};
}

/// What colour is made of: lights that shine directly, with shadows, and ambient light; light on
/// all its ways; the base colour as it is; nothing (black), for those who need the depth alone.
enum class RenderMode { direct, path, unlit, depth };

constexpr auto enum_names(RenderMode) {
  return std::array{std::pair{RenderMode::direct, "direct"}, std::pair{RenderMode::path, "path"},
                    std::pair{RenderMode::unlit, "unlit"}, std::pair{RenderMode::depth, "depth"}};
}

/// The mean light is the irradiance if all of the lights' flux into the bounding box of what is lit
/// spread evenly over the box's surface: 4 pi I / area of a point light inside, E / 4 of a
/// directional one. A scene without lights has a sky instead, without shadows: pi (1 + n . s) / 2
/// on a surface facing n, s being 30 degrees off the zenith, and pi / 2 its mean light, both scaled
/// so that a surface facing s shows its base colour.
///
/// Mode `path`: the same ambient light comes from infinitely far and only reaches what nothing
/// hides from it. Both sides of every triangle are seen, whatever glTF's doubleSided says.
struct RenderOptions {
  RendererKind kind = RendererKind::ray_tracer;
  RenderMode mode = RenderMode::direct;
  int samples = 4;          ///< colour samples per pixel at least; a square grid of them is taken
  double ambient = 0.3;     ///< constant light from all sides, as a share of the mean light
  double light_radius = 0;  ///< m, of point and spot lights as spheres; 0 casts sharp shadows
  int bounces = 4;          ///< mode `path`: reflections of light after the first

  int samples_per_edge() const;  ///< of the grid: the least whole number whose square suffices
  void validate() const;         ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, RenderOptions& options) {
  visit("kind", options.kind, "how the scene is rendered");
  visit("mode", options.mode, "how light is followed");
  visit("samples", options.samples, "colour samples per pixel, rounded up to a square grid");
  visit("ambient", options.ambient, "constant light from all sides, share of the lights' mean");
  visit("light_radius", options.light_radius, "of point and spot lights, m; 0: sharp shadows");
  visit("bounces", options.bounces, "mode path: reflections of light after the first");
}

using IdImage = cv::Mat_<std::uint16_t>;

/// What a perfect sensor would see. Each row's depth, normals and ids are those of the middle of
/// its exposure; colour is a mean over all of it.
struct RenderedFrame {
  cv::Mat_<cv::Vec3f> radiance;  ///< linear RGB, mean over the pixel's area
  vo::DepthImage depth;        ///< m along the optical axis, at the pixel's centre; 0 = nothing hit
  cv::Mat_<cv::Vec3f> normal;  ///< unit, camera's axes, of the triangle, towards the camera, or 0
  IdImage instance;            ///< at the pixel's centre, as SurfaceIds says; 0 = nothing hit
  IdImage material;            ///< the same
};

/// The channels that are wanted, nothing seen yet.
RenderedFrame empty_frame(const vo::PinholeCamera& camera, const Channels& channels);

/// Renders a scene. `render` may be called from several threads; its result depends on its
/// arguments alone.
class Renderer {
 public:
  Renderer() = default;
  virtual ~Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  Renderer(Renderer&&) = delete;
  Renderer& operator=(Renderer&&) = delete;

  virtual RenderedFrame render(const Capture& capture) const = 0;

  /// Colour and depth as a camera at rest sees them.
  RenderedFrame render(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera) const {
    return render(still(camera, T_world_camera));
  }
};

}  // namespace synth
