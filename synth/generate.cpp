#include "synth/generate.h"

#include <cstddef>
#include <memory>
#include <mutex>

#include <tbb/parallel_for.h>

#include "vo/core/error.h"

namespace synth {
namespace {

/// Counts finished frames and tells one thread at a time.
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

}  // namespace

void generate_sequence(const Scene& scene, const SequenceRecipe& recipe,
                       const std::filesystem::path& folder, const vo::Progress& progress) {
  const vo::Trajectory& truth = recipe.truth;
  vo::require(!truth.empty(), folder.string(), ": no poses to render, expected at least one");
  recipe.camera.validate();
  recipe.sensor.validate();
  const vo::PinholeCamera& camera = recipe.camera.pinhole;
  const std::unique_ptr<Renderer> renderer = make_renderer(scene, recipe.render);
  SensorOptions exposed = recipe.sensor;
  if (exposed.exposure == 0) {
    exposed.exposure = meter_exposure(scene, *renderer, camera, truth);
  }

  const vo::SequenceWriter writer(folder, recipe.camera, recipe.float_depth);
  FrameCounter counter(progress, truth.size());
  tbb::parallel_for(std::size_t{0}, truth.size(), [&](std::size_t i) {
    const RenderedFrame ideal = renderer->render(camera, truth[i].T_world_camera);
    writer.write_frame(i, measure(ideal, truth[i].timestamp, exposed));
    counter.add_one();
  });
  writer.finish(truth);
}

}  // namespace synth
