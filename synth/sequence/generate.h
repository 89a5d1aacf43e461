#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "synth/camera/rgbd_camera.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/sensor/sensor.h"
#include "synth/truth/truth_channels.h"
#include "synth/truth/truth_generator.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/files/output.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// All but the scene that determines a synthetic sequence.
struct SequenceRecipe {
  vo::Trajectory truth;  ///< T_world_camera of each frame, at its stamp
  CameraPath path;       ///< and at any time; empty = the spline through them, no velocity and IMU
  vo::RgbdCamera camera;
  RenderOptions render;
  SensorOptions sensor;
  vo::FloatDepth float_depth = vo::FloatDepth::none;
  TruthOptions channels;  ///< of exact ground truth, beside the poses
};

/// T_world_camera of the recipe at any time.
CameraPath path_of(const SequenceRecipe& recipe);

/// All files of a frame.
struct MadeFrame {
  std::vector<vo::NamedBytes> files;
  std::size_t depth_beyond_16_bit = 0;  ///< pixels that are 0 therefore
};

/// Makes the frames of one sequence, from any thread: each is a pure function of the scene, the
/// recipe and its index. Both must outlive it.
class FrameGenerator {
 public:
  FrameGenerator(const Scene& scene, const SequenceRecipe& recipe);

  MadeFrame make(std::size_t index) const;

 private:
  vo::RgbdFrame take(std::size_t index) const;

  const Scene& scene_;
  const SequenceRecipe& recipe_;
  SensorMotion motion_;
  bool moves_;  ///< each frame has a renderer of its own
  std::unique_ptr<const RenderersOverTime> renderers_;
  std::unique_ptr<const RgbdSensor> sensor_;
  std::unique_ptr<const TruthGenerator> truth_;  ///< none where no channel is asked for
};

/// The names of the files that `FrameGenerator::make` makes.
std::vector<std::string> frame_files(const SequenceRecipe& recipe, std::size_t index);

/// Those of the frames that lack a file in a folder. Files are complete if they are there.
std::vector<std::size_t> missing_frames(const SequenceRecipe& recipe,
                                        const std::vector<std::size_t>& frames,
                                        const std::filesystem::path& folder);

/// Renders, measures and writes these frames into an existing folder, in parallel on all cores.
/// Returns how many pixels of depth 16 bits could not hold.
std::size_t generate_frames(const Scene& scene, const SequenceRecipe& recipe,
                            const std::vector<std::size_t>& frames,
                            const std::filesystem::path& folder, const vo::Progress& progress);

/// Writes what a folder with all frames still lacks: the lists, groundtruth.txt, which is
/// `recipe.truth`, camera.toml, groundtruth_depth.txt where depth has stamps of its own, and the
/// channels that are not of single frames.
void finish_sequence(const SequenceRecipe& recipe, const std::filesystem::path& folder);

/// All frames, and the rest.
void generate_sequence(const Scene& scene, const SequenceRecipe& recipe,
                       const std::filesystem::path& folder, const vo::Progress& progress);

}  // namespace synth
