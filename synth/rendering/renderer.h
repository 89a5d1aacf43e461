#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

#include "synth/denoising/denoise.h"
#include "synth/rendering/capture.h"
#include "synth/rendering/triangle_point.h"
#include "vo/core/image.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

namespace synth {

enum class RendererKind { ray_tracer, rasterizer };

constexpr auto enum_names(RendererKind) {
  return std::array{std::pair{RendererKind::ray_tracer, "ray_tracer"},
                    std::pair{RendererKind::rasterizer, "rasterizer"}};
}

/// How radiance is computed: direct light with shadows and ambient light; path tracing; the base
/// colour without lighting; or none (black), where only depth is needed.
enum class RenderMode { direct, path, unlit, depth };

constexpr auto enum_names(RenderMode) {
  return std::array{std::pair{RenderMode::direct, "direct"}, std::pair{RenderMode::path, "path"},
                    std::pair{RenderMode::unlit, "unlit"}, std::pair{RenderMode::depth, "depth"}};
}

/// How a scene is rendered. Ambient light is a share of the mean irradiance, that of all the
/// lights' flux into the bounding box of lit surfaces if it spread evenly over the box's surface: 4
/// pi I / area for a point light inside, E / 4 for a directional one. A scene without lights has a
/// sky without shadows instead, of irradiance pi (1 + n . s) / 2 on a surface facing n, s being 30
/// degrees off the zenith, and of mean pi / 2, both scaled so that a surface facing s shows its
/// base colour.
///
/// In mode `path` ambient light comes from infinitely far and geometry occludes it. Both sides of
/// every triangle are visible, whatever glTF's doubleSided says.
struct RenderOptions {
  RendererKind kind = RendererKind::ray_tracer;
  RenderMode mode = RenderMode::direct;
  int samples = 4;          ///< least colour samples per pixel, rounded up to a square grid
  double ambient = 0.3;     ///< ambient light, as a share of the mean irradiance
  double light_radius = 0;  ///< m, radius of point and spot lights; 0 casts sharp shadows
  int bounces = 4;          ///< mode `path`: number of reflections after the first
  bool denoise = false;     ///< mode `path`: removes noise from the colour, 4 samples or more
  /// 0 to 8, frames before and as many after each frame of a sequence whose light helps to remove
  /// its noise; a single picture is by itself.
  int denoise_frames = 0;
  /// 1 to 16, most places at which a texture is read along the footprint of one colour sample on a
  /// slanted surface; 1 blurs across the slant as much as along it.
  int anisotropy = 1;

  int samples_per_edge() const;   ///< side of the sample grid, ceil(sqrt(samples))
  bool draws_projectors() const;  ///< whether infrared cameras see the light of projectors
  void validate() const;          ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, RenderOptions& options) {
  visit("kind", options.kind, "how the scene is rendered");
  visit("mode", options.mode, "how light is followed");
  visit("samples", options.samples, "colour samples per pixel, rounded up to a square grid");
  visit("ambient", options.ambient, "constant light from all sides, share of the lights' mean");
  visit("light_radius", options.light_radius, "of point and spot lights, m; 0: sharp shadows");
  visit("bounces", options.bounces, "mode path: reflections of light after the first");
  visit("denoise", options.denoise, "mode path: remove noise from the colour");
  visit("denoise_frames", options.denoise_frames,
        "frames of a sequence before and after each that help denoise, 0 to 8");
  visit("anisotropy", options.anisotropy,
        "most reads of a texture along a slanted sample, 1 to 16");
}

using IdImage = cv::Mat_<std::uint16_t>;

/// The kinds of surface that a depth camera meets first.
enum class FirstSurface : std::uint8_t {
  opaque,
  glass,   ///< transmits half of the light or more, and is smooth
  mirror,  ///< reflects half of the light or more, and is smooth
};

/// DepthSight holds what a depth camera meets at the pixels' centres if glass lets it see straight
/// through and mirrors reflect it, up to the first surface that is neither. All is as from one
/// straight ray, as if what a mirror shows were behind it; 0 where nothing was met. What is seen
/// through solids that refract (Capture::solids) is as far away as the optical path is long: the
/// sum of lengths times indices of refraction. Light that
/// returns is that of a lamp at the camera, as a share of what a white diffuse wall returns from 1
/// m straight ahead; the mean of red, green and blue stands for the lamp's colour.
struct DepthSight {
  cv::Mat_<std::uint8_t> first;       ///< FirstSurface
  cv::Mat_<float> returned;           ///< light that returns from the first surface
  vo::DepthImage beyond;              ///< m, CameraModel::depth of the opaque surface
  cv::Mat_<cv::Vec3f> beyond_normal;  ///< unit triangle normal, camera's axes, towards the camera
  cv::Mat_<float> beyond_returned;    ///< light that returns from the opaque surface
  /// The sum of the phasors of the light that reaches the pixel by way of other surfaces before the
  /// opaque one, as Capture::multipath says: real and imaginary part in the unit of
  /// beyond_returned, whose light has the phase 0. Empty without Channels::multipath.
  cv::Mat_<cv::Vec2f> multipath;
};

/// The images of an ideal sensor. Depth, normals and ids of a row are those of the middle of its
/// exposure; radiance is a mean over all of it.
struct RenderedFrame {
  cv::Mat_<cv::Vec3f> radiance;  ///< linear RGB, mean over the pixel's area; infrared: grey
  vo::DepthImage depth;          ///< m, CameraModel::depth at the pixel's centre; 0 = nothing hit
  cv::Mat_<cv::Vec3f> normal;    ///< unit triangle normal, camera's axes, towards the camera; or 0
  IdImage instance;              ///< SurfaceIds::instance at the pixel's centre; 0 = nothing hit
  IdImage material;              ///< SurfaceIds::material at the pixel's centre; 0 = nothing hit
  DepthSight sight;
  PointImage points;  ///< on triangles, at the pixels' centres
};

/// A rendered frame whose colour is not yet free of noise.
struct NoisyFrame {
  RenderedFrame frame;  ///< its radiance is empty or 0
  NoisyPicture picture;
};

/// Returns the frame with the radiance of its picture without most of its noise.
RenderedFrame without_noise(NoisyFrame noisy, const Capture& capture);

/// Returns a frame whose requested channels are allocated and 0 everywhere.
RenderedFrame empty_frame(const vo::CameraModel& camera, const Channels& channels);

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

  /// Renders a frame whose noise is to be removed by `without_noise`. Throws vo::Error unless the
  /// renderer was made with RenderOptions::denoise.
  virtual NoisyFrame render_noisy(const Capture& capture) const;

  /// Returns where a point of RenderedFrame::points is, m, world, at a time of the scene's
  /// animations, s, which is clamped to those that this renderer has the scene at, even if another
  /// renderer found the point. Throws vo::Error unless the renderer makes such points.
  virtual Eigen::Vector3d position(const TrianglePoint& point, double time) const;

  /// Renders colour and depth as a camera at rest sees them.
  RenderedFrame render(const vo::CameraModel& camera, const vo::SE3& T_world_camera) const {
    return render(still(camera, T_world_camera));
  }
};

}  // namespace synth
