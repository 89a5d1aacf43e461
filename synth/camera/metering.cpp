#include "synth/camera/metering.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "synth/scene/scene_motion.h"
#include "vo/core/median.h"

namespace synth {
namespace {

constexpr double kMiddleGrey = 0.18;
constexpr int kMeteringWidth = 80;  // px
constexpr std::size_t kMeteringPoses = 8;

/// Returns a camera with the view of `camera` and at most kMeteringWidth columns.
vo::CameraModel metering_camera(const vo::CameraModel& camera) {
  const int width = std::min(kMeteringWidth, camera.width());
  return camera.resized(width, std::max(1, camera.height() * width / camera.width()));
}

/// Returns the luminance of linear RGB after ITU-R BT.709.
float luminance(const cv::Vec3f& rgb) {
  return 0.2126F * rgb[0] + 0.7152F * rgb[1] + 0.0722F * rgb[2];
}

void append_luminances(const RenderedFrame& frame, std::vector<float>& luminances) {
  for (int v = 0; v < frame.depth.rows; ++v) {
    for (int u = 0; u < frame.depth.cols; ++u) {
      if (vo::has_depth(frame.depth(v, u))) {
        luminances.push_back(luminance(frame.radiance(v, u)));
      }
    }
  }
}

bool has_lit_surface(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
    return mesh.material == kNone || !scene.materials[mesh.material].unlit;
  });
}

/// Returns the colour that a camera sees of a view.
RenderedFrame seen(const Renderer& renderer, const vo::CameraModel& camera,
                   const vo::SE3& T_world_camera, const std::optional<InfraredBand>& infrared) {
  Capture capture = still(camera, T_world_camera);
  capture.infrared = infrared;
  return renderer.render(capture);
}

/// Returns the gain that brings the median, or an infrared camera's mean, to middle grey.
double exposure_of(const std::vector<float>& luminances, bool is_infrared) {
  if (luminances.empty()) {
    return 1;
  }
  const double middle = is_infrared ? std::accumulate(luminances.begin(), luminances.end(), 0.0) /
                                          static_cast<double>(luminances.size())
                                    : vo::upper_median(luminances);
  return middle > 0 ? kMiddleGrey / middle : 1;
}

}  // namespace

Metering meter(const Renderer& renderer, const vo::CameraModel& camera,
               const vo::SE3& T_world_camera, const std::optional<InfraredBand>& infrared) {
  const RenderedFrame view = seen(renderer, metering_camera(camera), T_world_camera, infrared);
  std::vector<float> luminances;
  append_luminances(view, luminances);
  Metering metering{.exposure = exposure_of(luminances, infrared.has_value())};
  const cv::Scalar mean = cv::mean(view.radiance);
  if (mean[0] > 0 && mean[1] > 0 && mean[2] > 0) {
    metering.mean = {mean[0], mean[1], mean[2]};
  }
  return metering;
}

double meter_exposure(const Scene& scene, const RenderersOverTime& renderers,
                      const vo::CameraModel& camera, const vo::Trajectory& trajectory,
                      double scene_delay, const std::optional<InfraredBand>& infrared) {
  const bool has_default_sky = scene.lights.empty() && scene.environment.empty();
  const bool has_final_colors = !infrared && (has_default_sky || !has_lit_surface(scene));
  if (has_final_colors || trajectory.empty()) {
    return 1;
  }
  const vo::CameraModel small = metering_camera(camera);
  const std::size_t poses = std::min(kMeteringPoses, trajectory.size());
  std::vector<float> luminances;
  for (std::size_t i = 0; i < poses; ++i) {
    const std::size_t index = i * (trajectory.size() - 1) / std::max<std::size_t>(1, poses - 1);
    const auto& [stamp, T_world_camera] = trajectory[index];
    const auto renderer = renderers.at(scene_time(trajectory, stamp) + scene_delay);
    append_luminances(seen(*renderer, small, T_world_camera, infrared), luminances);
  }
  return exposure_of(luminances, infrared.has_value());
}

}  // namespace synth
