#include "synth/sequence/generate.h"

#include <utility>

#include "synth/camera/make_renderer.h"
#include "synth/scene/scene_motion.h"
#include "synth/sensor/noise_model.h"
#include "synth/sensor/pinhole_effects.h"
#include "vo/core/error.h"
#include "vo/frames/depth_units.h"
#include "vo/motion_files/trajectory_file.h"

namespace synth {
namespace {

vo::SequenceLayout layout_of(const SequenceRecipe& recipe) {
  return {.camera = written_camera(recipe),
          .float_depth = recipe.float_depth,
          .depth_delay = recipe.sensor.depth.delay};
}

/// Returns T_world_camera at the stamps of the depth images.
vo::Trajectory depth_truth(const SequenceRecipe& recipe) {
  const CameraPath path = path_of(recipe);
  vo::Trajectory truth;
  for (const vo::StampedPose& pose : recipe.truth) {
    const double stamp = pose.timestamp + recipe.sensor.depth.delay;
    truth.push_back({stamp, path(stamp)});
  }
  return truth;
}

/// A moving scene during a frame, and its renderer.
struct MovingScene {
  SceneDuring during;
  std::unique_ptr<const Renderer> renderer;
};

}  // namespace

vo::RgbdCameraModel written_camera(const SequenceRecipe& recipe) {
  vo::RgbdCameraModel camera = recipe.camera;
  camera.depth_noise = depth_noise_model(recipe.sensor, camera);
  return camera;
}

CameraPath path_of(const SequenceRecipe& recipe) {
  return recipe.path ? recipe.path : path_through(recipe.truth);
}

NeededTextures needed_textures(const SequenceRecipe& recipe) {
  const RenderMode mode = recipe.render.mode;
  const bool is_lit = mode == RenderMode::direct || mode == RenderMode::path;
  if (is_lit && recipe.render.kind == RendererKind::ray_tracer) {
    return NeededTextures::all;
  }
  const bool shows_surfaces = recipe.channels.has(TruthChannel::edges) ||  // some are in textures
                              recipe.channels.has(TruthChannel::depth_beyond) ||
                              recipe.sensor.depth.materials.is_on() ||
                              recipe.sensor.depth.multipath.is_on();
  if (is_lit || shows_surfaces) {
    return NeededTextures::surfaces;
  }
  return mode == RenderMode::depth ? NeededTextures::alpha : NeededTextures::base_color;
}

FrameGenerator::FrameGenerator(const Scene& scene, const SequenceRecipe& recipe,
                               std::vector<std::uint16_t> instance_classes,
                               std::shared_ptr<const RenderersOverTime> renderers)
    : scene_(scene),
      recipe_(recipe),
      motion_{recipe.truth, path_of(recipe), recipe.scene_delay},
      moves_(moves(scene)),
      renderers_(std::move(renderers)) {
  vo::require(!recipe.truth.empty(), "sequence: no poses to render, expected at least one");
  require_within_reach(recipe.truth);
  recipe.camera.validate();
  recipe.sensor.validate();
  require_pinhole_effects(recipe.sensor, recipe.camera.model);
  if (!renderers_) {
    renderers_ = std::make_shared<const RenderersOverTime>(scene, recipe.render);
  }
  sensor_ = std::make_unique<SequenceCamera>(scene, *renderers_, recipe.camera.model, motion_,
                                             recipe.sensor, recipe.infrared);
  if (recipe.render.denoise_frames > 0) {
    denoised_ = std::make_unique<const DenoisedFrames>(
        FrameSource{recipe.truth.size(),
                    [this](std::size_t index) { return sensor_->color_capture(index); },
                    [this](std::size_t index) { return renderer_at(index); }},
        recipe.render.denoise_frames);
  }
  if (!recipe.channels.channels.empty()) {
    truth_ = std::make_unique<const TruthGenerator>(
        TruthSubject{scene, recipe.camera.model, recipe.truth, recipe.render.ambient,
                     recipe.scene_delay, std::move(instance_classes)},
        recipe.channels);
  }
}

/// Returns a renderer of the scene as it moves during a frame.
std::shared_ptr<const Renderer> FrameGenerator::renderer_at(std::size_t index) const {
  if (!moves_) {
    return sensor_->renderer_at(index);
  }
  const TimeSpan span = sensor_->span(index);
  const double now =
      scene_time(recipe_.truth, recipe_.truth.at(index).timestamp) + recipe_.scene_delay;
  const auto moving =
      std::make_shared<MovingScene>(MovingScene{scene_during(scene_, now, span.begin, span.end)});
  moving->renderer = make_renderer(moving->during, recipe_.render);
  return {moving, moving->renderer.get()};
}

vo::RgbdFrame FrameGenerator::take(std::size_t index) const {
  if (denoised_) {
    const DenoisedFrame frame = denoised_->render(index);
    return sensor_->take(index, *frame.renderer, frame.rendered);
  }
  return sensor_->take(index, *renderer_at(index));
}

MadeFrame FrameGenerator::make(std::size_t index) const {
  const vo::RgbdFrame frame = take(index);
  MadeFrame made{vo::encode_frame(layout_of(recipe_), index, frame),
                 vo::count_beyond_16_bit(frame.depth, recipe_.camera.depth_units_per_m)};
  if (truth_) {
    const std::vector<vo::NamedBytes> exact = truth_->make(index);
    made.files.insert(made.files.end(), exact.begin(), exact.end());
  }
  return made;
}

std::vector<std::string> frame_files(const SequenceRecipe& recipe, std::size_t index) {
  std::vector<std::string> files = vo::frame_files(layout_of(recipe), index);
  for (const TruthFile& file : truth_files(recipe.channels, index, recipe.truth.size())) {
    files.push_back(file.name);
  }
  return files;
}

std::string depth_file(const SequenceRecipe& recipe, std::size_t index) {
  return vo::frame_files(layout_of(recipe), index).at(1);
}

std::vector<vo::NamedBytes> sequence_files(const SequenceRecipe& recipe) {
  std::vector<vo::NamedBytes> files = vo::encode_lists(layout_of(recipe), recipe.truth);
  for (vo::NamedBytes& file : encode_motion(recipe.channels, recipe.path, recipe.truth)) {
    files.push_back(std::move(file));
  }
  if (recipe.sensor.depth.delay != 0) {
    files.push_back({"groundtruth_depth.txt", vo::format_trajectory(depth_truth(recipe))});
  }
  return files;
}

}  // namespace synth
