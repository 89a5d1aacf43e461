#include "tools/train_edges/labelled_views.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>

#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include "synth/camera/make_renderer.h"
#include "synth/camera/metering.h"
#include "synth/camera/renderers_over_time.h"
#include "synth/gltf/gltf.h"
#include "synth/rendering/renderer.h"
#include "synth/sensor/sensor.h"
#include "tools/train_edges/free_view.h"
#include "vo/core/error.h"

namespace tools {
namespace {

vo::PinholeCamera random_camera(const ViewOptions& options, vo::Random& random) {
  const double fov = random.uniform(options.min_fov_deg, options.max_fov_deg);
  return vo::PinholeCamera::from_horizontal_fov(options.width, options.height, fov);
}

vo::ColorImage noisy(const vo::ColorImage& image, double deviation, vo::Random& random) {
  vo::ColorImage result(image.size());
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      for (int channel = 0; channel < 3; ++channel) {
        result(v, u)[channel] =
            cv::saturate_cast<uchar>(image(v, u)[channel] + 255 * deviation * random.normal());
      }
    }
  }
  return result;
}

/// Returns the labels where the image has at least this contrast within 5x5 px, in any channel.
synth::EdgeLabels visible(const synth::EdgeLabels& labels, const vo::ColorImage& image,
                          double min_contrast) {
  cv::Mat brightest;
  cv::Mat darkest;
  const cv::Mat window = cv::Mat::ones(5, 5, CV_8U);
  cv::dilate(image, brightest, window);
  cv::erode(image, darkest, window);
  cv::Mat channels[3];
  cv::split(brightest - darkest, channels);
  const cv::Mat contrast = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  synth::EdgeLabels result(labels.size(), 0);
  labels.copyTo(result, contrast >= 255 * min_contrast);
  return result;
}

/// A scene with its renderer and tracer, from which labelled views are made.
class Studio {
 public:
  Studio(const std::filesystem::path& path, const ViewOptions& options)
      : options_(options),
        path_(path.string()),
        scene_(synth::load_gltf(path)),
        renderer_(synth::make_renderer(scene_, render_)),
        tracer_(scene_, render_.ambient) {}

  LabelledView photograph(std::size_t index) const {
    vo::Random random(options_.seed, index);
    const vo::PinholeCamera camera = random_camera(options_, random);
    const std::optional<vo::SE3> T_world_camera = free_view(tracer_, camera, random);
    vo::require(T_world_camera.has_value(), path_,
                ": no free place inside it was found for a camera");
    const vo::ColorImage image = clear_photo(camera, *T_world_camera, random);
    const synth::EdgeLabels labels =
        synth::edge_labels(tracer_.trace(camera, *T_world_camera), camera, options_.labels);
    return {noisy(image, random.uniform(0, options_.noise), random),
            visible(labels, image, options_.min_contrast)};
  }

 private:
  vo::ColorImage clear_photo(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera,
                             vo::Random& random) const {
    synth::RenderedFrame ideal = renderer_->render(camera, T_world_camera);
    const double blur = random.uniform(0, options_.blur_px);
    if (blur > 0.2) {
      cv::GaussianBlur(ideal.radiance, ideal.radiance, {}, blur);
    }
    const double metered = synth::meter_exposure(scene_, synth::RenderersOverTime(renderer_),
                                                 camera, {{0, T_world_camera}});
    const double stops = random.uniform(-options_.exposure_stops, options_.exposure_stops);
    const vo::RgbdFrame frame = synth::measure(ideal, 0, {.exposure = metered * std::exp2(stops)});
    return noisy(frame.image, random.uniform(0, options_.noise), random);
  }

  const ViewOptions& options_;
  std::string path_;
  synth::RenderOptions render_;
  synth::Scene scene_;
  std::shared_ptr<const synth::Renderer> renderer_;
  synth::SurfaceTracer tracer_;
};

}  // namespace

void ViewOptions::validate() const {
  vo::require(views >= 1 && views <= 100000, "views: expected 1 to 100000, got ", views);
  vo::require(width >= 32 && height >= 32 && width <= 8192 && height <= 8192,
              "width, height: expected 32 to 8192 px, got ", width, ", ", height);
  vo::require(min_fov_deg > 0 && max_fov_deg >= min_fov_deg && max_fov_deg < 180,
              "min_fov_deg, max_fov_deg: expected 0 < min <= max < 180, got ", min_fov_deg, ", ",
              max_fov_deg);
  vo::require(exposure_stops >= 0 && exposure_stops <= 8, "exposure_stops: expected 0 to 8, got ",
              exposure_stops);
  vo::require(noise >= 0 && noise <= 1, "noise: expected 0 to 1, got ", noise);
  vo::require(blur_px >= 0 && blur_px <= 10, "blur_px: expected 0 to 10, got ", blur_px);
  vo::require(min_contrast >= 0 && min_contrast <= 1, "min_contrast: expected 0 to 1, got ",
              min_contrast);
  labels.validate();
}

std::vector<LabelledView> render_labelled_views(const std::filesystem::path& scene,
                                                const ViewOptions& options,
                                                const vo::Progress& progress) {
  options.validate();
  const Studio studio(scene, options);
  const auto count = static_cast<std::size_t>(options.views);
  std::vector<LabelledView> views(count);
  std::size_t done = 0;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    views[i] = studio.photograph(i);
    const std::lock_guard lock(mutex);
    ++done;
    if (progress) {
      progress(done, count);
    }
  });
  return views;
}

}  // namespace tools
