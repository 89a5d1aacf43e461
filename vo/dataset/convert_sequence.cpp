#include "vo/dataset/convert_sequence.h"

#include <string>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/euroc.h"
#include "vo/dataset/icl_nuim.h"
#include "vo/dataset/sequence.h"
#include "vo/frames/depth_units.h"
#include "vo/motion_files/imu_file.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/output_folders/output_folder.h"

namespace vo {
namespace {

SE3 pose_of(const SequenceSource& source, const RgbdFrame& frame) {
  const auto T_world_camera = pose_at(source.truth, frame.timestamp);
  require(T_world_camera.has_value(), "ICL-NUIM: expected a pose of every frame, got none at ",
          frame.timestamp, " s");
  return *T_world_camera;
}

std::vector<NamedBytes> encode_frame(const SequenceSource& source, WrittenSequence format,
                                     std::size_t index, const RgbdFrame& frame) {
  switch (format) {
    case WrittenSequence::tum:
      return encode_frame({source.camera}, index, frame);
    case WrittenSequence::euroc:
      return encode_euroc_frame(source.camera, frame);
    case WrittenSequence::icl_nuim:
      return encode_icl_nuim_frame(source.camera, index, frame, pose_of(source, frame));
    case WrittenSequence::icl_tum:
      return encode_icl_tum_frame(source.camera, index, frame);
  }
  return {};
}

/// Encodes a TUM folder's lists, which have a line for each stamp, and its poses and IMU readings,
/// which have stamps of their own.
std::vector<NamedBytes> encode_tum_lists(const SequenceSource& source) {
  std::vector<NamedBytes> files = encode_image_lists({source.camera}, source.timestamps);
  if (!source.truth.empty()) {
    files.push_back({"groundtruth.txt", format_trajectory(source.truth)});
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

std::vector<NamedBytes> encode_lists(const SequenceSource& source, WrittenSequence format,
                                     bool has_depth) {
  switch (format) {
    case WrittenSequence::tum:
      return encode_tum_lists(source);
    case WrittenSequence::euroc:
      return encode_euroc_lists(source, has_depth);
    case WrittenSequence::icl_nuim:
      return encode_icl_nuim_lists(source);
    case WrittenSequence::icl_tum:
      return encode_icl_tum_lists(source);
  }
  return {};
}

}  // namespace

ConvertOutcome convert_sequence(const ConvertJob& job, const OutputPolicy& policy,
                                const Progress& progress) {
  ConvertOutcome outcome;
  outcome.from = job.from ? *job.from : detect_format(job.in);
  const SequenceSource source = open_sequence(job.in, outcome.from, job.camera);
  if (job.to == WrittenSequence::euroc) {
    require_nanoseconds_apart(source.timestamps);
  }
  OutputFolder output(job.out, policy, [&] { progress(0, 0); });
  bool has_depth = false;
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const RgbdFrame frame = source.read(i);
    require(!frame.depth.empty() || job.to == WrittenSequence::euroc, job.in.string(),
            ": has no depth, which ", to_string(job.to), " expects");
    has_depth = !frame.depth.empty();
    if (job.to != WrittenSequence::icl_nuim) {
      outcome.depth_beyond_16_bit +=
          count_beyond_16_bit(frame.depth, source.camera.depth_units_per_m);
    }
    output.write(encode_frame(source, job.to, i, frame));
    progress(i + 1, source.timestamps.size());
  }
  output.write(encode_lists(source, job.to, has_depth));
  output.commit();
  outcome.frames = source.timestamps.size();
  outcome.poses = source.truth.size();
  outcome.imu_samples = source.imu.samples.size();
  outcome.notes = source.notes;
  return outcome;
}

}  // namespace vo
