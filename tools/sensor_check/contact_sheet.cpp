#include "tools/sensor_check/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include "synth/camera/renderers_over_time.h"
#include "synth/camera/sequence_camera.h"
#include "synth/gltf/scene_file.h"
#include "synth/scene/scene.h"
#include "synth/sensor/preset.h"
#include "tools/pictures/panels.h"
#include "tools/pictures/webp.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using Picture = cv::Mat_<cv::Vec3b>;

constexpr double kFar = 4;       // depth at the end of the colour map, m
constexpr double kError = 0.03;  // error at full saturation, m
constexpr int kEnlargement = 4;  // magnification of the centre
constexpr std::size_t kRows = enum_names(synth::SensorPreset{}).size();
constexpr std::size_t kColumns = 5;  // of row_of

Picture enlarged_middle(const cv::Mat& image) {
  const cv::Size part(image.cols / kEnlargement, image.rows / kEnlargement);
  const cv::Rect middle((image.cols - part.width) / 2, (image.rows - part.height) / 2, part.width,
                        part.height);
  Picture result;
  cv::resize(image(middle), result, image.size(), 0, 0, cv::INTER_NEAREST);
  return result;
}

Picture colored(const vo::DepthImage& depth) {
  cv::Mat_<uchar> code(depth.size());
  std::transform(depth.begin(), depth.end(), code.begin(),
                 [](float value) { return cv::saturate_cast<uchar>(255 * value / kFar); });
  Picture result;
  cv::applyColorMap(code, result, cv::COLORMAP_TURBO);
  result.setTo(cv::Scalar::all(0), depth == 0);
  return result;
}

cv::Vec3b error_color(float measured, float exact) {
  if (!vo::has_depth(measured) || !vo::has_depth(exact)) {
    return {0, 0, 0};
  }
  const double error = std::clamp((measured - exact) / kError, -1.0, 1.0);
  const auto pale = static_cast<uchar>(255 * (1 - std::abs(error)));
  return error > 0 ? cv::Vec3b(pale, pale, 255) : cv::Vec3b(255, pale, pale);
}

Picture error_picture(const vo::DepthImage& measured, const vo::DepthImage& exact) {
  Picture result(exact.size());
  std::transform(measured.begin(), measured.end(), exact.begin(), result.begin(), error_color);
  return result;
}

/// Returns the measured surface shaded by a light from the upper left, which shows steps and noise.
Picture relief(const vo::DepthImage& depth, const vo::PinholeCamera& camera) {
  const Eigen::Vector3d to_light = Eigen::Vector3d(-1, -1, -1).normalized();
  Picture result(depth.size(), cv::Vec3b(0, 0, 0));
  for (int v = 0; v + 1 < depth.rows; ++v) {
    for (int u = 0; u + 1 < depth.cols; ++u) {
      if (!vo::has_depth(depth(v, u)) || !vo::has_depth(depth(v, u + 1)) ||
          !vo::has_depth(depth(v + 1, u))) {
        continue;
      }
      const Eigen::Vector3d p = camera.unproject({u, v}, depth(v, u));
      const Eigen::Vector3d right = camera.unproject({u + 1, v}, depth(v, u + 1)) - p;
      const Eigen::Vector3d down = camera.unproject({u, v + 1}, depth(v + 1, u)) - p;
      const double light = std::max(0.0, down.cross(right).normalized().dot(to_light));
      result(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(40 + 215 * light));
    }
  }
  return result;
}

std::vector<Picture> row_of(std::string_view name, const vo::RgbdFrame& frame,
                            const vo::PinholeCamera& camera, const vo::DepthImage& exact) {
  return {titled(frame.image.clone(), std::string(name)),
          titled(enlarged_middle(frame.image), vo::concat("x", kEnlargement)),
          titled(colored(frame.depth), vo::concat("depth, 0 to ", kFar, " m")),
          titled(relief(frame.depth, camera), "depth, lit"),
          titled(error_picture(frame.depth, exact), vo::concat("error, +-", 1000 * kError, " mm"))};
}

Picture draw_contact_sheet(const synth::Scene& scene, const synth::RenderersOverTime& renderers,
                           const vo::PinholeCamera& camera, const synth::CameraTruth& motion,
                           const vo::Progress& progress) {
  std::vector<std::vector<Picture>> rows;
  vo::DepthImage exact;
  for (const auto& [preset, name] : enum_names(synth::SensorPreset{})) {
    const synth::SequenceCamera sensor(scene, renderers, camera, motion,
                                       synth::preset_options(preset));
    const vo::RgbdFrame taken = sensor.take(motion.truth.size() / 2);
    exact = exact.empty() ? taken.depth : exact;
    rows.push_back(row_of(name, taken, camera, exact));
    progress(rows.size(), kRows);
  }
  return montage(rows);
}

}  // namespace

void require_sheet_size(int width, int height) {
  constexpr int kMostOfWebp = 16383;
  constexpr int kMostWide = kMostOfWebp / static_cast<int>(kColumns);
  constexpr int kMostHigh = kMostOfWebp / static_cast<int>(kRows);
  vo::require(
      width >= kEnlargement && height >= kEnlargement && width <= kMostWide && height <= kMostHigh,
      "expected ", kEnlargement, "x", kEnlargement, " to ", kMostWide, "x", kMostHigh,
      " px, of which a contact sheet can be made");
}

std::string contact_sheet(const std::filesystem::path& scene, const synth::RenderOptions& render,
                          const vo::PinholeCamera& camera, const synth::PathOptions& path,
                          const vo::Progress& progress) {
  const synth::SceneFile file(scene);
  const synth::RenderersOverTime renderers(file.scene(), render);
  const synth::TimedPath timed = synth::make_path(path, file);
  const synth::CameraTruth motion{synth::sample(timed.path, timed.times), timed.path};
  constexpr double kQuality = 88;  // of 100; noise makes lossless files five times as large
  return encode_webp(draw_contact_sheet(file.scene(), renderers, camera, motion, progress),
                     kQuality);
}

}  // namespace tools
