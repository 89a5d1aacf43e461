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
    case WrittenSequence::mcap:
      break;  // a file, not a folder
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
    case WrittenSequence::mcap:
      break;
  }
  return {};
}

/// Writes the folder of a sequence; returns how many pixels of depth 16 bits do not hold.
std::size_t write_folder(const ConvertJob& job, const SequenceSource& source,
                         const OutputPolicy& policy, const Progress& progress) {
  if (job.to == WrittenSequence::euroc) {
    require_nanoseconds_apart(source.timestamps);
  }
  OutputFolder output(job.out, policy, [&] { progress(0, 0); });
  bool has_depth = false;
  std::size_t beyond_16_bit = 0;
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const RgbdFrame frame = source.read(i);
    require(!frame.depth.empty() || job.to == WrittenSequence::euroc, job.in.string(),
            ": has no depth, which ", to_string(job.to), " expects");
    has_depth = !frame.depth.empty();
    if (job.to != WrittenSequence::icl_nuim) {
      beyond_16_bit += count_beyond_16_bit(frame.depth, source.camera.depth_units_per_m);
    }
    output.write(encode_frame(source, job.to, i, frame));
    progress(i + 1, source.timestamps.size());
  }
  output.write(encode_lists(source, job.to, has_depth));
  output.commit();
  return beyond_16_bit;
}

/// Returns sentences on what of a sequence an MCAP file does not hold.
std::vector<std::string> left_out_of_mcap(const ConvertJob& job, const SequenceSource& source) {
  std::vector<std::string> notes;
  if (!source.imu.samples.empty()) {
    notes.push_back(concat(job.out.string(), ": the IMU's ", source.imu.samples.size(),
                           " samples are not written"));
  }
  if (source.camera.readout.is_rolling() || source.camera.depth_noise.is_known()) {
    notes.push_back(job.out.string() +
                    ": CameraInfo holds neither the read-out time nor the depth noise of the "
                    "camera; --camera gives them again");
  }
  return notes;
}

}  // namespace

ConvertOutcome convert_sequence(const ConvertJob& job, const OutputPolicy& policy,
                                const Progress& progress) {
  ConvertOutcome outcome;
  outcome.from = job.from ? *job.from : detect_format(job.in);
  const SequenceSource source = open_sequence(job.in, outcome.from, job.camera, job.recorded);
  outcome.frames = source.timestamps.size();
  outcome.poses = source.truth.size();
  outcome.notes = source.notes;
  if (job.to == WrittenSequence::mcap) {
    write_mcap_sequence(job.out, source, job.mcap, job.mcap_clouds, policy, progress);
    const std::vector<std::string> notes = left_out_of_mcap(job, source);
    outcome.notes.insert(outcome.notes.end(), notes.begin(), notes.end());
    return outcome;
  }
  outcome.depth_beyond_16_bit = write_folder(job, source, policy, progress);
  outcome.imu_samples = source.imu.samples.size();
  return outcome;
}

}  // namespace vo
