#include "tools/datasets/parts/frame_rows.h"

#include <utility>

#include "tools/datasets/layout.h"
#include "tools/datasets/parts/archive_names.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {

std::string frame_columns(const DatasetSpec& spec) {
  return vo::concat(
      "split,sequence,frame,timestamp,archive,rgb,depth,tx,ty,tz,qx,qy,qz,qw,flow_px,blur_px,"
      "depth_coverage,textured_share,clearance_m",
      spec.rig ? ",camera" : "", "\n");
}

FrameRows::FrameRows(const DatasetSequence& sequence, const SequenceJob& job, std::size_t camera,
                     const DatasetPart& part, std::string archive)
    : sequence_(sequence),
      job_(job.cameras[camera]),
      camera_(job.camera_name(camera)),
      first_(part.first),
      archive_(std::move(archive)),
      checks_(synth::check_frames(job_.scene.scene(), job_.recipe.camera.model, timed_path(job_),
                                  {part.first, part.end})) {}

std::string FrameRows::row(std::size_t frame, double depth_coverage) const {
  const vo::Trajectory& truth = job_.recipe.truth;
  const vo::StampedPose& pose = truth[frame];
  const synth::FrameCheck& check = checks_[frame - first_];
  const Eigen::Vector3d& t = pose.T_world_camera.translation();
  const Eigen::Quaterniond q = pose.T_world_camera.rotation();
  const std::string folder =
      scene_folder(sequence_) + sequence_.name + "/" + (camera_.empty() ? "" : camera_ + "/");
  const std::vector<std::string> files = synth::frame_files(job_.recipe, frame);
  std::string text = vo::concat(sequence_.split, ",", sequence_.name, ",", frame, ",",
                                vo::format_real(pose.timestamp), ",", archive_);
  for (const std::size_t image : {0, 1}) {  // rgb, depth
    text += "," + (archive_.empty() ? folder + files[image]
                                    : archive_name(sequence_.name, camera_, files[image]));
  }
  for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
    text += "," + vo::format_real(value);
  }
  if (frame + 1 < truth.size()) {
    const double exposed =
        job_.recipe.sensor.shutter.exposure_time / (truth[frame + 1].timestamp - pose.timestamp);
    text += vo::concat(",", vo::format_real(check.flow_px), ",",
                       vo::format_real(check.flow_px * exposed));
  } else {
    text += ",,";
  }
  for (const double value : {depth_coverage, check.textured_share, check.clearance}) {
    text += "," + vo::format_real(value);
  }
  return text + (camera_.empty() ? "" : "," + camera_) + "\n";
}

}  // namespace tools
