#include "synth/rendering/renderer.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace synth {

void RenderOptions::validate() const {
  constexpr int kMaxSamples = 65536;
  constexpr int kMaxBounces = 64;
  constexpr int kMaxAnisotropy = 16;
  constexpr int kMaxDenoiseFrames = 8;
  vo::require(samples >= 1 && samples <= kMaxSamples, "render: expected samples from 1 to ",
              kMaxSamples, ", got ", samples);
  vo::require(ambient >= 0 && std::isfinite(ambient),
              "render: expected ambient at or above 0, got ", ambient);
  vo::require(light_radius >= 0 && std::isfinite(light_radius),
              "render: expected light_radius at or above 0 m, got ", light_radius);
  vo::require(bounces >= 0 && bounces <= kMaxBounces, "render: expected bounces from 0 to ",
              kMaxBounces, ", got ", bounces);
  vo::require(anisotropy >= 1 && anisotropy <= kMaxAnisotropy,
              "render: expected anisotropy from 1 to ", kMaxAnisotropy, ", got ", anisotropy);
  vo::require(!denoise || (kind == RendererKind::ray_tracer && mode == RenderMode::path),
              "render: denoise is for mode path of the ray tracer, got mode ", vo::to_string(mode),
              " of the ", vo::to_string(kind));
  vo::require(!denoise || samples_per_edge() > 1,
              "render: denoise compares samples, expected at least 2 of them, got ", samples);
  vo::require(denoise_frames >= 0 && denoise_frames <= kMaxDenoiseFrames,
              "render: expected denoise_frames from 0 to ", kMaxDenoiseFrames, ", got ",
              denoise_frames);
  vo::require(denoise || denoise_frames == 0, "render: denoise_frames ", denoise_frames,
              " needs denoise");
  vo::require(kind != RendererKind::rasterizer || mode != RenderMode::path,
              "render: the rasterizer cannot follow paths, expected mode direct, unlit or depth");
}

int RenderOptions::samples_per_edge() const {
  return static_cast<int>(std::ceil(std::sqrt(samples)));
}

bool RenderOptions::draws_projectors() const {
  return kind == RendererKind::ray_tracer &&
         (mode == RenderMode::direct || mode == RenderMode::path);
}

RenderedFrame empty_frame(const vo::CameraModel& camera, const Channels& channels) {
  const cv::Size size(camera.width(), camera.height());
  const cv::Vec3f none(0, 0, 0);
  RenderedFrame frame;
  if (channels.color) {
    frame.radiance = cv::Mat_<cv::Vec3f>(size, none);
  }
  if (channels.depth) {
    frame.depth = vo::DepthImage(size, 0.0F);
  }
  if (channels.normal) {
    frame.normal = cv::Mat_<cv::Vec3f>(size, none);
  }
  if (channels.sight) {
    frame.sight = {cv::Mat_<std::uint8_t>(size, std::uint8_t{0}),
                   cv::Mat_<float>(size, 0.0F),
                   vo::DepthImage(size, 0.0F),
                   cv::Mat_<cv::Vec3f>(size, none),
                   cv::Mat_<float>(size, 0.0F),
                   cv::Mat_<cv::Vec2f>()};
  }
  if (channels.multipath) {
    frame.sight.multipath = cv::Mat_<cv::Vec2f>(size, cv::Vec2f(0, 0));
  }
  if (channels.ids) {
    frame.instance = IdImage(size, std::uint16_t{0});
    frame.material = IdImage(size, std::uint16_t{0});
  }
  if (channels.points) {
    frame.points = {size, std::vector<TrianglePoint>(static_cast<std::size_t>(size.area()))};
  }
  return frame;
}

RenderedFrame without_noise(NoisyFrame noisy, const Capture& capture) {
  RenderedFrame frame = std::move(noisy.frame);
  frame.radiance = capture.camera.wraps() ? denoised_round(noisy.picture) : denoised(noisy.picture);
  if (capture.infrared) {
    frame.radiance = grey_of(frame.radiance);
  }
  return frame;
}

NoisyFrame Renderer::render_noisy(const Capture& /*capture*/) const {
  throw vo::Error("render: denoise is for mode path of the ray tracer");
}

Eigen::Vector3d Renderer::position(const TrianglePoint& /*point*/, double /*time*/) const {
  throw vo::Error("render: points of triangles are made by the ray tracer alone");
}

}  // namespace synth
