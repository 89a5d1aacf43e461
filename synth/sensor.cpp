#include "synth/sensor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "synth/srgb.h"
#include "vo/core/error.h"

namespace synth {
namespace {

constexpr int kMeteringWidth = 80;  // px
constexpr std::size_t kMeteringPoses = 8;

/// Same view, fewer pixels.
vo::PinholeCamera metering_camera(const vo::PinholeCamera& camera) {
  vo::PinholeCamera small = camera;
  small.width = std::min(kMeteringWidth, camera.width);
  small.height = std::max(1, camera.height * small.width / camera.width);
  const double x_scale = static_cast<double>(small.width) / camera.width;
  const double y_scale = static_cast<double>(small.height) / camera.height;
  small.fx = camera.fx * x_scale;
  small.fy = camera.fy * y_scale;
  small.cx = (camera.cx + 0.5) * x_scale - 0.5;
  small.cy = (camera.cy + 0.5) * y_scale - 0.5;
  return small;
}

/// Of ITU-R BT.709.
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

}  // namespace

void SensorOptions::validate() const {
  vo::require(exposure >= 0 && std::isfinite(exposure),
              "sensor: expected exposure at or above 0, got ", exposure);
  vo::require(min_depth >= 0 && max_depth > min_depth,
              "sensor: expected 0 <= min_depth < max_depth, got ", min_depth, ", ", max_depth);
}

double meter_exposure(const Scene& scene, const Renderer& renderer, const vo::PinholeCamera& camera,
                      const vo::Trajectory& trajectory) {
  constexpr double kMiddleGrey = 0.18;
  if (scene.lights.empty() || !has_lit_surface(scene) || trajectory.empty()) {
    return 1;
  }
  const vo::PinholeCamera small = metering_camera(camera);
  const std::size_t poses = std::min(kMeteringPoses, trajectory.size());
  std::vector<float> luminances;
  for (std::size_t i = 0; i < poses; ++i) {
    const std::size_t index = i * (trajectory.size() - 1) / std::max<std::size_t>(1, poses - 1);
    append_luminances(renderer.render(small, trajectory[index].T_world_camera), luminances);
  }
  if (luminances.empty()) {
    return 1;
  }
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  return *middle > 0 ? kMiddleGrey / *middle : 1;
}

vo::RgbdFrame measure(const RenderedFrame& ideal, double timestamp, const SensorOptions& options) {
  vo::require(options.exposure > 0, "sensor: expected an exposure above 0, got ", options.exposure);
  const auto gain = static_cast<float>(options.exposure);
  vo::ColorImage image(ideal.radiance.size());
  std::transform(
      ideal.radiance.begin(), ideal.radiance.end(), image.begin(), [gain](const cv::Vec3f& rgb) {
        return cv::Vec3b(encode_srgb_8bit(gain * rgb[2]), encode_srgb_8bit(gain * rgb[1]),
                         encode_srgb_8bit(gain * rgb[0]));
      });
  vo::DepthImage depth(ideal.depth.size());
  std::transform(ideal.depth.begin(), ideal.depth.end(), depth.begin(), [&](float value) {
    return value >= options.min_depth && value <= options.max_depth ? value : 0.0F;
  });
  return {.timestamp = timestamp, .image = image, .depth = depth};
}

}  // namespace synth
