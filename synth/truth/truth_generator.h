#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "synth/scene/scene.h"
#include "synth/truth/truth_channels.h"
#include "vo/files/output.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// The inputs of a truth generator. Its references must outlive the generator.
struct TruthSubject {
  const Scene& scene;
  vo::CameraModel camera;
  const vo::Trajectory& trajectory;
  double ambient = 0;      ///< RenderOptions::ambient of the sequence
  double scene_delay = 0;  ///< s, the time of the scene's animations at the first stamp
  std::vector<std::uint16_t> instance_classes = {};  ///< as class_truth needs it, if that is asked
};

/// Makes the exact ground truth of any frame, from any thread, as seen at its stamp in an instant,
/// without rolling shutter, exposure time and sensor effects.
class TruthGenerator {
 public:
  TruthGenerator(const TruthSubject& subject, const TruthOptions& options);
  ~TruthGenerator();
  TruthGenerator(const TruthGenerator&) = delete;
  TruthGenerator& operator=(const TruthGenerator&) = delete;
  TruthGenerator(TruthGenerator&&) = delete;
  TruthGenerator& operator=(TruthGenerator&&) = delete;

  std::vector<vo::NamedBytes> make(std::size_t index) const;  ///< contents of `truth_files`

 private:
  class Instant;
  struct Frame;

  std::shared_ptr<const Instant> instant(std::size_t index) const;  ///< scene at its stamp
  std::string encode(const Frame& frame, TruthChannel channel) const;

  TruthSubject subject_;
  TruthOptions options_;
  std::shared_ptr<const Instant> still_;  ///< null if the scene moves
};

}  // namespace synth
