#include "vo/exports/convert_sequence.h"

#include <string>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/exports/convert_rig.h"
#include "vo/exports/fit_to_target.h"
#include "vo/exports/pixel_truth_files.h"
#include "vo/frames/depth_units.h"
#include "vo/output_folders/output_folder.h"
#include "vo/recordings/mcap_sequence.h"
#include "vo/rigs/rig_file.h"
#include "vo/videos/write_video.h"

namespace vo {
namespace {

/// The channels of ground truth of a job's sequence that its target takes as they are, and the
/// names of those that it does not.
struct CarriedTruth {
  std::vector<TruthChannelFiles> carried;
  std::vector<std::string> dropped;
};

/// TUM's layout alone holds channels. Those of directions in a world that is turned are dropped.
CarriedTruth carried_truth(const ConvertJob& job, SequenceFormat from, const SequenceSource& source,
                           WorldUp up_before) {
  CarriedTruth truth;
  if (from != SequenceFormat::tum) {
    return truth;
  }
  for (TruthChannelFiles& channel : truth_channels_in(job.in)) {
    const bool is_turned =
        source.up != up_before && (channel.name == "normal" || channel.name == "velocity");
    if (job.to == WrittenSequence::tum && !is_turned &&
        is_of_frames(channel, source.timestamps.size())) {
      truth.carried.push_back(std::move(channel));
    } else {
      truth.dropped.push_back("truth/" + channel.name);
    }
  }
  return truth;
}

/// What was written of the images of a sequence.
struct WrittenImages {
  DepthImages depth = DepthImages::absent;
  std::size_t depth_beyond_16_bit = 0;

  void see(const RgbdFrame& frame) {
    if (!frame.depth.empty() && depth != DepthImages::delayed) {
      depth = frame.depth_delay == 0 ? DepthImages::present : DepthImages::delayed;
    }
  }
};

WrittenImages write_folder(const ConvertJob& job, const SequenceSource& source,
                           const std::vector<TruthChannelFiles>& carried,
                           const OutputPolicy& policy, const Progress& progress) {
  const SequenceTarget target = make_target(job.to, source);
  const double depth_units = written_depth_units(job.to, source);
  WrittenImages written;
  OutputFolder output(job.out, policy, [&] { progress(0, 0); });
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const RgbdFrame frame = source.read(i);
    require(!frame.depth.empty() || traits_of(job.to).depth == Need::optional, job.in.string(),
            ": has no depth, which ", to_string(job.to), " expects");
    written.see(frame);
    if (depth_units > 0) {
      written.depth_beyond_16_bit += count_beyond_16_bit(frame.depth, depth_units);
    }
    output.write(target.encode_frame(i, frame));
    for (const TruthChannelFiles& channel : carried) {
      output.write(read_truth_of_frame(channel, i));
    }
    progress(i + 1, source.timestamps.size());
  }
  output.write(target.encode_lists());
  output.commit();
  return written;
}

/// Writes the images as a video, and finds whether they have depth.
WrittenImages write_images(const ConvertJob& job, const SequenceSource& source,
                           const OutputPolicy& policy, const Progress& progress) {
  WrittenImages written;
  SequenceSource images = source;
  images.read = [&](std::size_t index) {
    RgbdFrame frame = source.read(index);
    written.see(frame);
    return frame;
  };
  write_video(job.out, images, policy, progress);
  return written;
}

}  // namespace

ConvertOutcome convert_sequence(const ConvertJob& job, const OutputPolicy& policy,
                                const Progress& progress) {
  ConvertOutcome outcome;
  if (job.to == WrittenSequence::video) {
    require_video_name(job.out);
  }
  if (!job.from && is_rig(job.in)) {
    return convert_rig(job, policy, progress);
  }
  outcome.from = job.from ? *job.from : detect_format(job.in);
  SequenceSource opened = open_sequence(job.in, outcome.from, job.camera, job.recorded);
  const WorldUp up_before = opened.up;
  const SequenceSource source = fit_to_target(job, std::move(opened));
  const CarriedTruth truth = carried_truth(job, outcome.from, source, up_before);
  WrittenImages written;
  if (job.to == WrittenSequence::mcap) {
    write_mcap_sequence(job.out, source, job.mcap, job.mcap_clouds, policy, progress);
  } else if (job.to == WrittenSequence::video) {
    written = write_images(job, source, policy, progress);
  } else {
    written = write_folder(job, source, truth.carried, policy, progress);
  }
  outcome.frames = source.timestamps.size();
  outcome.poses = traits_of(job.to).holds_poses ? source.truth.size() : 0;
  outcome.up = source.up;
  outcome.imu_samples = traits_of(job.to).holds_imu ? source.imu.samples.size() : 0;
  outcome.depth_beyond_16_bit = written.depth_beyond_16_bit;
  outcome.dropped = list_dropped(job.to, source, written.depth);
  outcome.dropped.insert(outcome.dropped.end(), truth.dropped.begin(), truth.dropped.end());
  outcome.notes = source.notes;
  return outcome;
}

}  // namespace vo
