#include "vo/exports/convert_sequence.h"

#include <string>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/exports/source_views.h"
#include "vo/frames/depth_units.h"
#include "vo/output_folders/output_folder.h"
#include "vo/recordings/mcap_sequence.h"

namespace vo {
namespace {

/// Opens the sequence of a job and takes from it what its target needs.
SequenceSource open_for_target(const ConvertJob& job, SequenceFormat from) {
  SequenceSource source = open_sequence(job.in, from, job.camera, job.recorded);
  const TargetTraits traits = traits_of(job.to);
  const double fy = source.camera.pinhole.fy;
  require(fy > 0 || traits.holds_y_up, job.in.string(), ": its camera has y up, fy = ", fy,
          ", expected one with y down for ", to_string(job.to));
  if (traits.poses == Need::required ||
      (traits.poses == Need::all_or_none && !source.truth.empty())) {
    source = frames_with_poses(std::move(source), job.in.string(), to_string(job.to));
  }
  if (!holds_lens(job.to, source.camera.pinhole.distortion)) {
    source = undistorted(std::move(source), to_string(job.to));
  }
  return source;
}

/// What was written of the images of a sequence.
struct WrittenImages {
  DepthImages depth = DepthImages::absent;
  std::size_t depth_beyond_16_bit = 0;
};

WrittenImages write_folder(const ConvertJob& job, const SequenceSource& source,
                           const OutputPolicy& policy, const Progress& progress) {
  const SequenceTarget target = make_target(job.to, source);
  const double depth_units = written_depth_units(job.to, source);
  WrittenImages written;
  OutputFolder output(job.out, policy, [&] { progress(0, 0); });
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const RgbdFrame frame = source.read(i);
    require(!frame.depth.empty() || traits_of(job.to).depth == Need::optional, job.in.string(),
            ": has no depth, which ", to_string(job.to), " expects");
    if (!frame.depth.empty()) {
      written.depth = DepthImages::present;
    }
    if (depth_units > 0) {
      written.depth_beyond_16_bit += count_beyond_16_bit(frame.depth, depth_units);
    }
    output.write(target.encode_frame(i, frame));
    progress(i + 1, source.timestamps.size());
  }
  output.write(target.encode_lists());
  output.commit();
  return written;
}

}  // namespace

ConvertOutcome convert_sequence(const ConvertJob& job, const OutputPolicy& policy,
                                const Progress& progress) {
  ConvertOutcome outcome;
  outcome.from = job.from ? *job.from : detect_format(job.in);
  const SequenceSource source = open_for_target(job, outcome.from);
  WrittenImages written;
  if (job.to == WrittenSequence::mcap) {
    write_mcap_sequence(job.out, source, job.mcap, job.mcap_clouds, policy, progress);
  } else {
    written = write_folder(job, source, policy, progress);
  }
  outcome.frames = source.timestamps.size();
  outcome.poses = source.truth.size();
  outcome.imu_samples = traits_of(job.to).holds_imu ? source.imu.samples.size() : 0;
  outcome.depth_beyond_16_bit = written.depth_beyond_16_bit;
  outcome.dropped = list_dropped(job.to, source, written.depth);
  outcome.notes = source.notes;
  return outcome;
}

}  // namespace vo
