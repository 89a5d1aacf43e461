#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "synth/path/camera_path.h"
#include "synth/truth/edge_labels.h"
#include "synth/truth/imu.h"
#include "vo/files/float_image.h"
#include "vo/files/output.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// What can be known exactly about a sequence beside its poses. `truth_convention` says how each is
/// written.
enum class TruthChannel {
  depth,
  normal,
  instance,
  material,
  flow,
  occlusion,
  edges,
  moving,
  velocity,  ///< of the whole sequence, as `imu` is; the others are of each frame
  imu,
};

constexpr auto enum_names(TruthChannel) {
  using enum TruthChannel;
  return std::array{std::pair{depth, "depth"},       std::pair{normal, "normal"},
                    std::pair{instance, "instance"}, std::pair{material, "material"},
                    std::pair{flow, "flow"},         std::pair{occlusion, "occlusion"},
                    std::pair{edges, "edges"},       std::pair{moving, "moving"},
                    std::pair{velocity, "velocity"}, std::pair{imu, "imu"}};
}

struct TruthOptions {
  std::vector<TruthChannel> channels;  ///< in their order above, each once
  vo::FloatFormat float_format = vo::FloatFormat::npy;
  EdgeLabelOptions edges;
  ImuOptions imu;

  bool has(TruthChannel channel) const;
  void validate() const;  ///< throws vo::Error
};

/// Names with commas between, or `all`. Throws vo::Error.
std::vector<TruthChannel> parse_channels(std::string_view text);

/// Folder, file type, unit, frame and sign, in one sentence.
std::string truth_convention(TruthChannel channel, vo::FloatFormat format);

struct TruthFile {
  TruthChannel channel = TruthChannel::depth;
  std::string name;
};

/// Of a frame of a sequence of `frames`: flow and occlusion are to the next, so that the last has
/// none.
std::vector<TruthFile> truth_files(const TruthOptions& options, std::size_t index,
                                   std::size_t frames);

/// The files of the channels that are not of single frames. `path` need only be set for these.
std::vector<vo::NamedBytes> encode_motion(const TruthOptions& options, const CameraPath& path,
                                          const vo::Trajectory& trajectory);

}  // namespace synth
