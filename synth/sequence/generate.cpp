#include "synth/sequence/generate.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include <tbb/parallel_for.h>

#include "synth/camera/make_renderer.h"
#include "synth/scene/scene_motion.h"
#include "synth/sensor/noise_model.h"
#include "vo/core/error.h"
#include "vo/dataset/depth_units.h"
#include "vo/dataset/trajectory_file.h"

namespace synth {
namespace {

/// Counts finished frames and reports progress, from one thread at a time.
class FrameCounter {
 public:
  FrameCounter(const vo::Progress& progress, std::size_t total)
      : progress_(progress), total_(total) {}

  void add_one() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (progress_) {
      progress_(done_, total_);
    }
  }

 private:
  const vo::Progress& progress_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

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

}  // namespace

vo::RgbdCamera written_camera(const SequenceRecipe& recipe) {
  vo::RgbdCamera camera = recipe.camera;
  camera.depth_noise = depth_noise_model(recipe.sensor, camera);
  return camera;
}

CameraPath path_of(const SequenceRecipe& recipe) {
  return recipe.path ? recipe.path : path_through(recipe.truth);
}

NeededTextures needed_textures(const SequenceRecipe& recipe) {
  if (recipe.channels.has(TruthChannel::edges)) {  // some of which are edges in textures
    return NeededTextures::all;
  }
  switch (recipe.render.mode) {
    case RenderMode::depth:
      return NeededTextures::alpha;
    case RenderMode::unlit:
      return NeededTextures::base_color;
    case RenderMode::direct:
    case RenderMode::path:
      return NeededTextures::all;
  }
  return NeededTextures::all;
}

FrameGenerator::FrameGenerator(const Scene& scene, const SequenceRecipe& recipe)
    : scene_(scene), recipe_(recipe), motion_{recipe.truth, path_of(recipe)}, moves_(moves(scene)) {
  vo::require(!recipe.truth.empty(), "sequence: no poses to render, expected at least one");
  require_within_reach(recipe.truth);
  recipe.camera.validate();
  recipe.sensor.validate();
  renderers_ = std::make_unique<const RenderersOverTime>(scene, recipe.render);
  sensor_ = std::make_unique<SequenceCamera>(scene, *renderers_, recipe.camera.pinhole, motion_,
                                             recipe.sensor);
  if (!recipe.channels.channels.empty()) {
    truth_ = std::make_unique<const TruthGenerator>(
        TruthSubject{scene, recipe.camera.pinhole, recipe.truth, recipe.render.ambient},
        recipe.channels);
  }
}

vo::RgbdFrame FrameGenerator::take(std::size_t index) const {
  if (!moves_) {
    return sensor_->take(index);
  }
  const TimeSpan span = sensor_->span(index);
  const double now = scene_time(recipe_.truth, recipe_.truth.at(index).timestamp);
  const SceneDuring during = scene_during(scene_, now, span.begin, span.end);
  return sensor_->take(index, *make_renderer(during, recipe_.render));
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

std::vector<std::size_t> missing_frames(const SequenceRecipe& recipe,
                                        const std::vector<std::size_t>& frames,
                                        const std::filesystem::path& folder) {
  std::vector<std::size_t> missing;
  for (const std::size_t frame : frames) {
    const std::vector<std::string> files = frame_files(recipe, frame);
    if (!std::all_of(files.begin(), files.end(), [&](const std::string& file) {
          return std::filesystem::is_regular_file(folder / file);
        })) {
      missing.push_back(frame);
    }
  }
  return missing;
}

std::size_t generate_frames(const Scene& scene, const SequenceRecipe& recipe,
                            const std::vector<std::size_t>& frames,
                            const std::filesystem::path& folder, const vo::Progress& progress) {
  if (frames.empty()) {
    return 0;
  }
  const FrameGenerator generator(scene, recipe);
  FrameCounter counter(progress, frames.size());
  std::atomic<std::size_t> depth_beyond_16_bit = 0;
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    const MadeFrame made = generator.make(frames[i]);
    vo::write_files(folder, made.files, vo::ExistingOutput::replace);
    depth_beyond_16_bit += made.depth_beyond_16_bit;
    counter.add_one();
  });
  return depth_beyond_16_bit;
}

void finish_sequence(const SequenceRecipe& recipe, const std::filesystem::path& folder) {
  std::vector<vo::NamedBytes> files = vo::encode_lists(layout_of(recipe), recipe.truth);
  for (vo::NamedBytes& file : encode_motion(recipe.channels, recipe.path, recipe.truth)) {
    files.push_back(std::move(file));
  }
  if (recipe.sensor.depth.delay != 0) {
    files.push_back({"groundtruth_depth.txt", vo::format_trajectory(depth_truth(recipe))});
  }
  vo::write_files(folder, files, vo::ExistingOutput::replace);
}

}  // namespace synth
