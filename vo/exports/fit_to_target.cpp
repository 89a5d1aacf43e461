#include "vo/exports/fit_to_target.h"

#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/exports/source_views.h"
#include "vo/motion_files/timestamp.h"
#include "vo/recordings/mcap_sequence.h"

namespace vo {

SequenceSource fit_to_target(const ConvertJob& job, SequenceSource source) {
  const TargetTraits traits = traits_of(job.to);
  const double fy = source.camera.pinhole.fy;
  require(fy > 0 || traits.holds_y_up, job.in.string(), ": its camera has y up, fy = ", fy,
          ", expected one with y down for ", to_string(job.to));
  if (job.to == WrittenSequence::mcap) {
    require_mcap_stamps(source, job.in.string());
  }
  if (job.to == WrittenSequence::mcap || job.to == WrittenSequence::euroc) {
    require_nanoseconds_apart(source.timestamps, job.in.string());
  }
  if (traits.poses == Need::required ||
      (traits.poses == Need::all_or_none && !source.truth.empty())) {
    source = frames_with_poses(std::move(source), job.in.string(), to_string(job.to));
  }
  if (job.up != WorldUp::unknown && !traits.may_choose_world) {
    fail_as(ErrorKind::usage, "--world: ", to_string(job.to),
            " has a world of its own, expected none");
  }
  const WorldUp up = job.up == WorldUp::unknown ? traits.up : job.up;
  if (up != WorldUp::unknown) {
    source = in_world(std::move(source), up);
  }
  if (!holds_lens(job.to, source.camera.pinhole.distortion)) {
    source = undistorted(std::move(source), to_string(job.to));
  }
  return source;
}

}  // namespace vo
