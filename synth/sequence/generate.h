#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synth/camera/sequence_camera.h"
#include "synth/gltf/gltf.h"
#include "synth/rendering/infrared.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/sensor/sensor.h"
#include "synth/sequence/denoised_frames.h"
#include "synth/truth/truth_channels.h"
#include "synth/truth/truth_generator.h"
#include "vo/dataset/sequence.h"
#include "vo/files/output.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// Everything but the scene that determines a synthetic sequence.
struct SequenceRecipe {
  vo::Trajectory truth;  ///< T_world_camera of each frame, at its stamp
  CameraPath path;       ///< T_world_camera at any time; if empty: a spline, no velocity or IMU
  vo::RgbdCameraModel camera;
  RenderOptions render;
  SensorOptions sensor;
  vo::FloatDepth float_depth = vo::FloatDepth::none;
  TruthOptions channels;   ///< exact ground truth to write beside the poses
  double scene_delay = 0;  ///< s, the time of the scene's animations at the first stamp
  std::optional<InfraredBand> infrared;  ///< how an infrared camera sees; none: it sees colours
};

/// Returns the recipe's camera with the depth noise of its sensor, as camera.toml tells it.
vo::RgbdCameraModel written_camera(const SequenceRecipe& recipe);

/// Returns the recipe's camera path or, where it is empty, the spline through its poses.
CameraPath path_of(const SequenceRecipe& recipe);

/// Returns the textures that the recipe's images and channels depend on.
NeededTextures needed_textures(const SequenceRecipe& recipe);

/// The encoded files of one frame.
struct MadeFrame {
  std::vector<vo::NamedBytes> files;
  std::size_t depth_beyond_16_bit = 0;  ///< pixels stored as 0 because 16 bits cannot hold them
};

/// Called with each frame that was made, from any thread but never from two at once.
using MadeFrameObserver = std::function<void(std::size_t index, const MadeFrame& frame)>;

/// Makes the frames of one sequence, from any thread: each is a pure function of the scene, the
/// recipe and its index. The scene and the recipe must outlive the generator.
class FrameGenerator {
 public:
  /// `instance_classes` is the class of each of the scene's instances, where the recipe's channels
  /// have `class`. `renderers` are those of the scene and of `recipe.render`; null: it makes its
  /// own.
  FrameGenerator(const Scene& scene, const SequenceRecipe& recipe,
                 std::vector<std::uint16_t> instance_classes = {},
                 std::shared_ptr<const RenderersOverTime> renderers = nullptr);
  ~FrameGenerator() = default;
  FrameGenerator(const FrameGenerator&) = delete;
  FrameGenerator& operator=(const FrameGenerator&) = delete;
  FrameGenerator(FrameGenerator&&) = delete;
  FrameGenerator& operator=(FrameGenerator&&) = delete;

  MadeFrame make(std::size_t index) const;

 private:
  std::shared_ptr<const Renderer> renderer_at(std::size_t index) const;
  vo::RgbdFrame take(std::size_t index) const;

  const Scene& scene_;
  const SequenceRecipe& recipe_;
  CameraTruth motion_;
  bool moves_;  ///< whether the scene moves, so that each frame has its own renderer
  std::shared_ptr<const RenderersOverTime> renderers_;
  std::unique_ptr<const SequenceCamera> sensor_;
  std::unique_ptr<const DenoisedFrames> denoised_;  ///< null if each frame is rendered by itself
  std::unique_ptr<const TruthGenerator> truth_;     ///< null where no channel is asked for
};

/// Returns the names of the files that `FrameGenerator::make` makes.
std::vector<std::string> frame_files(const SequenceRecipe& recipe, std::size_t index);

/// Returns the name of a frame's 16-bit depth image, one of its `frame_files`.
std::string depth_file(const SequenceRecipe& recipe, std::size_t index);

/// Returns the files that belong to no single frame: the lists, groundtruth.txt (`recipe.truth`),
/// camera.toml, groundtruth_depth.txt where depth has stamps of its own, and the velocity and IMU
/// channels.
std::vector<vo::NamedBytes> sequence_files(const SequenceRecipe& recipe);

}  // namespace synth
