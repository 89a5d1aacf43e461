#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "synth/scene/scene.h"
#include "synth/truth/truth_channels.h"
#include "vo/files/output.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// What a truth generator is about; all but `ambient` must outlive it.
struct TruthSubject {
  const Scene& scene;
  const vo::PinholeCamera& camera;
  const vo::Trajectory& trajectory;
  double ambient = 0;  ///< RenderOptions::ambient
};

/// Makes the ground truth of any frame, from any thread: at its stamp, as if the camera took it in
/// an instant, whatever the shutter and the sensor do.
class TruthGenerator {
 public:
  TruthGenerator(const TruthSubject& subject, const TruthOptions& options);
  ~TruthGenerator();
  TruthGenerator(const TruthGenerator&) = delete;
  TruthGenerator& operator=(const TruthGenerator&) = delete;
  TruthGenerator(TruthGenerator&&) = delete;
  TruthGenerator& operator=(TruthGenerator&&) = delete;

  std::vector<vo::NamedBytes> make(std::size_t index) const;  ///< `truth_files`

 private:
  class Instant;
  struct Frame;

  std::shared_ptr<const Instant> instant(std::size_t index) const;  ///< of a frame
  std::string encode(const Frame& frame, TruthChannel channel) const;

  TruthSubject subject_;
  TruthOptions options_;
  std::shared_ptr<const Instant> still_;  ///< of a scene that does not move
};

}  // namespace synth
