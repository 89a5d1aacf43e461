#include "synth/rig/camera_jobs.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "synth/camera/make_renderer.h"
#include "synth/path/camera_path.h"
#include "synth/rendering/infrared.h"
#include "synth/rig/projector_pattern.h"
#include "synth/sensor/pinhole_effects.h"
#include "synth/sensor/preset.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/geometry/trajectory.h"
#include "vo/text_files/toml_file.h"

namespace synth {
namespace {

bool is_identity(const vo::SE3& T) {
  return T.rotation().vec().isZero(0) && T.translation().isZero(0);
}

/// Returns the path of a camera on a body; the body's own where both are one.
CameraPath path_on(const CameraPath& body, const vo::SE3& T_body_camera) {
  if (is_identity(T_body_camera)) {
    return body;
  }
  return [body, T_body_camera](double time) { return body(time) * T_body_camera; };
}

/// Returns the poses of a path at the stamps of others, each `offset` s later.
vo::Trajectory poses_at(const CameraPath& path, const vo::Trajectory& stamps, double offset) {
  vo::Trajectory poses;
  for (const vo::StampedPose& stamp : stamps) {
    const double time = stamp.timestamp + offset;
    poses.push_back({time, path(time)});
  }
  return poses;
}

/// Returns the sensor of camera `number`: what its file says, on top of its preset, which else is
/// `base`. Without a seed of its own it has one that no other camera has, since noise is a function
/// of seed, frame and pixel.
SensorOptions sensor_of(const vo::RigCamera& camera, const SensorOptions& base,
                        std::size_t number) {
  SensorOptions sensor = base;
  std::vector<vo::Field> fields = vo::fields_of(sensor);
  for (const vo::TomlValue& value : camera.sensor) {
    if (value.key == "preset") {
      vo::assign_fields({value}, fields);
      sensor = preset_options(sensor.preset);
    }
  }
  sensor.seed = base.seed + number;
  vo::assign_fields(camera.sensor, fields);
  try {
    sensor.validate();
    require_pinhole_effects(sensor, camera.camera.model);
  } catch (const vo::Error& error) {
    vo::fail(vo::describe(camera), ": sensor: ", error.what());
  }
  return sensor;
}

/// Gives the channels of a pair to a camera that has a partner, and takes them from one without.
void choose_channels(const vo::Rig& rig, const vo::RigCamera& camera, TruthOptions& options) {
  if (camera.stereo.empty()) {
    std::erase_if(options.channels, is_of_pair);
  } else if (std::any_of(options.channels.begin(), options.channels.end(), is_of_pair)) {
    options.stereo_baseline = vo::stereo_baseline(rig, camera);
  }
}

/// Returns the patterns of a rig's projectors; none where no camera sees their light.
std::vector<cv::Mat_<float>> patterns_of(const vo::Rig& rig, const RenderOptions& render) {
  constexpr std::size_t kMostPixels = std::size_t{1} << 26U;  // 256 MB
  std::vector<cv::Mat_<float>> patterns;
  if (!render.draws_projectors() || !vo::has_infrared_camera(rig)) {
    return patterns;
  }
  std::size_t pixels = 0;
  for (const vo::RigProjector& projector : rig.projectors) {
    patterns.push_back(pattern_of(projector));
    pixels += patterns.back().total();
    vo::require(pixels <= kMostPixels, vo::describe(projector), ": pattern: expected at most ",
                kMostPixels, " pixels in the patterns of all projectors, got ", pixels,
                " up to this one");
  }
  return patterns;
}

/// Returns how a camera of a rig sees infrared light, `patterns` being the projectors' or empty
/// where they are not drawn; none if it sees colours.
std::optional<InfraredBand> infrared_of(const vo::Rig& rig, const vo::RigCamera& camera,
                                        const std::vector<cv::Mat_<float>>& patterns) {
  if (camera.spectrum != vo::Spectrum::infrared) {
    return std::nullopt;
  }
  InfraredBand band{.scene_light = camera.scene_light};
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const vo::RigProjector& projector = rig.projectors[i];
    band.projectors.push_back(
        {.name = projector.name,
         .T_camera_projector = camera.T_body_camera.inverse() * projector.T_body_projector,
         .half_extent = half_extent_of(projector),
         .power = projector.power,
         .pattern = patterns[i]});
  }
  return band;
}

RenderJob camera_job(const RigJob& job, std::size_t number) {
  const vo::RigCamera& camera = job.rig.cameras[number];
  RenderJob own = job.body;
  SequenceRecipe& recipe = own.recipe;
  recipe.camera = camera.camera;
  recipe.sensor = sensor_of(camera, recipe.sensor, number);
  try {
    require_drawable(recipe.camera.model, recipe.sensor.shutter, recipe.render);
  } catch (const vo::Error& error) {
    vo::fail(vo::describe(camera), ": ", error.what());
  }
  recipe.path = path_on(path_of(job.body.recipe), camera.T_body_camera);
  recipe.truth = is_identity(camera.T_body_camera) && camera.time_offset == 0
                     ? job.body.recipe.truth
                     : poses_at(recipe.path, job.body.recipe.truth, camera.time_offset);
  recipe.scene_delay = camera.time_offset;
  if (recipe.channels.imu.has_noise()) {
    recipe.channels.imu.seed += number + 1;  // the body's own IMU has the seed itself
  }
  choose_channels(job.rig, camera, recipe.channels);
  return own;
}

}  // namespace

std::vector<RenderJob> camera_jobs(const RigJob& job) {
  std::vector<RenderJob> jobs;
  const std::vector<cv::Mat_<float>> patterns = patterns_of(job.rig, job.body.recipe.render);
  for (std::size_t i = 0; i < job.rig.cameras.size(); ++i) {
    jobs.push_back(camera_job(job, i));
    jobs.back().recipe.infrared = infrared_of(job.rig, job.rig.cameras[i], patterns);
  }
  const std::vector<TruthChannel>& channels = job.body.recipe.channels.channels;
  const bool has_pair = std::any_of(job.rig.cameras.begin(), job.rig.cameras.end(),
                                    [](const vo::RigCamera& c) { return !c.stereo.empty(); });
  const auto of_pair = std::find_if(channels.begin(), channels.end(), is_of_pair);
  vo::require(has_pair || of_pair == channels.end(),
              "channels: ", of_pair == channels.end() ? "" : vo::to_string(*of_pair),
              ": expected a camera of the rig that names its partner, stereo = \"NAME\"");
  return jobs;
}

NeededTextures needed_textures(const RigJob& job) {
  NeededTextures needed = NeededTextures::alpha;
  SequenceRecipe recipe = job.body.recipe;
  for (std::size_t i = 0; i < job.rig.cameras.size(); ++i) {
    recipe.sensor = sensor_of(job.rig.cameras[i], job.body.recipe.sensor, i);
    needed = std::min(needed, needed_textures(recipe));  // what each needs, the earlier ones have
  }
  return needed;
}

}  // namespace synth
