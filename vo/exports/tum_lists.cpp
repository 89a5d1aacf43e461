#include "vo/exports/tum_lists.h"

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/colour_sequence.h"
#include "vo/motion_files/imu_file.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {

SequenceLayout tum_layout(const SequenceSource& source) {
  return {.camera = source.camera,
          .float_depth = source.has_float_depth ? FloatDepth::npy : FloatDepth::none};
}

std::vector<NamedBytes> encode_tum_lists(const SequenceSource& source,
                                         const std::vector<double>& depth_stamps) {
  std::vector<NamedBytes> files =
      depth_stamps.empty()
          ? encode_colour_lists(source.camera, source.timestamps)
          : encode_image_lists(tum_layout(source), source.timestamps, depth_stamps);
  if (!source.truth.empty()) {
    files.push_back({"groundtruth.txt", format_trajectory(source.truth)});
  }
  if (!source.truth.empty() && source.up != WorldUp::unknown) {
    files.push_back({kWorldFile, concat("up = \"", to_string(source.up), "\"\n")});
  }
  if (!source.imu.samples.empty()) {
    files.push_back({"imu.csv", format_imu(source.imu.samples)});
    files.push_back({"imu.toml", format_imu_noise(source.imu.noise)});
  }
  if (!source.imu.states.empty()) {
    files.push_back({"truth/imu_states.csv", format_states(source.imu.states)});
  }
  return files;
}

}  // namespace vo
