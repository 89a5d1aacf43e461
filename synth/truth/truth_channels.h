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
#include "synth/truth/surface_classes.h"
#include "vo/files/output.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/trajectory.h"
#include "vo/image_files/float_image.h"

namespace synth {

/// A channel of exact ground truth beside the poses. `truth_convention` describes its files.
enum class TruthChannel {
  depth,
  normal,
  instance,
  material,
  surface_class,  ///< of surfaces that TruthOptions::classes tell apart
  flow,
  occlusion,
  edges,
  moving,
  velocity,  ///< belongs to the whole sequence, as `imu` does, not to each frame
  imu,
  disparity,  ///< needs a stereo partner, as `stereo_occlusion` does
  stereo_occlusion,
  depth_beyond,  ///< of DepthSight
};

constexpr auto enum_names(TruthChannel) {
  using enum TruthChannel;
  return std::array{std::pair{depth, "depth"},
                    std::pair{normal, "normal"},
                    std::pair{instance, "instance"},
                    std::pair{material, "material"},
                    std::pair{surface_class, "class"},
                    std::pair{flow, "flow"},
                    std::pair{occlusion, "occlusion"},
                    std::pair{edges, "edges"},
                    std::pair{moving, "moving"},
                    std::pair{velocity, "velocity"},
                    std::pair{imu, "imu"},
                    std::pair{disparity, "disparity"},
                    std::pair{stereo_occlusion, "stereo_occlusion"},
                    std::pair{depth_beyond, "depth_beyond"}};
}

struct TruthOptions {
  std::vector<TruthChannel> channels;  ///< in the order of TruthChannel, each once
  vo::FloatFormat float_format = vo::FloatFormat::npy;
  std::vector<SurfaceClass> classes;  ///< the first that matches a surface is its class
  EdgeLabelOptions edges;
  ImuOptions imu;
  /// m, to the camera on the right in a rectified pair of which this is the left; 0 = there is none
  double stereo_baseline = 0;

  bool has(TruthChannel channel) const;
  void validate() const;  ///< throws vo::Error if out of range
};

/// Returns whether a channel is of a stereo pair.
bool is_of_pair(TruthChannel channel);

/// Parses names separated by commas, of which `all` is every one that a single camera has but
/// `class` and `depth_beyond`. Throws vo::Error for unknown or repeated names.
std::vector<TruthChannel> parse_channels(std::string_view text);

/// Returns a channel's folder, file type, unit, frame and sign convention, in one sentence, of a
/// camera's images.
std::string truth_convention(TruthChannel channel, vo::FloatFormat format,
                             const vo::CameraModel& camera);

struct TruthFile {
  TruthChannel channel = TruthChannel::depth;
  std::string name;
};

/// Returns the files of a frame in a sequence of `frames` frames. Flow and occlusion lead to the
/// next frame, so that the last frame has none.
std::vector<TruthFile> truth_files(const TruthOptions& options, std::size_t index,
                                   std::size_t frames);

/// Returns the files of what an IMU measures.
std::vector<vo::NamedBytes> encode_imu(const vo::ImuRecord& record);

/// Returns the files of the velocity and IMU channels, which alone require `path` to be set.
std::vector<vo::NamedBytes> encode_motion(const TruthOptions& options, const CameraPath& path,
                                          const vo::Trajectory& trajectory);

}  // namespace synth
