#include "vo/exports/convert_rig.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/euroc.h"
#include "vo/exports/fit_to_target.h"
#include "vo/exports/pixel_truth_files.h"
#include "vo/exports/source_views.h"
#include "vo/frames/depth_timestamp.h"
#include "vo/frames/depth_units.h"
#include "vo/motion_files/imu_file.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/output_folders/output_folder.h"
#include "vo/rigs/rig_file.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

bool is_pinhole(const RigCamera& camera) {
  return camera.camera.model.pinhole() != nullptr;
}

void require_convertible(const ConvertJob& job, const Rig& rig) {
  const auto first = std::find_if(rig.cameras.begin(), rig.cameras.end(), is_pinhole);
  require(first != rig.cameras.end(), job.in.string(),
          ": expected a camera of the rig that is a pinhole, ", to_string(job.to),
          " holds no others");
  require(job.to == WrittenSequence::euroc, job.in.string(), ": is a rig of ", rig.cameras.size(),
          " cameras, which euroc alone holds; expected the folder of one of them, ",
          (job.in / first->name).string(), ", for ", to_string(job.to));
  if (job.camera) {
    fail_as(ErrorKind::usage, "--camera: expected none for the cameras of a rig, ",
            job.in.string());
  }
}

/// Opens the sequence of a rig's camera as the job's target can hold it, with its pose in the body
/// and without an IMU, which the rig has.
SequenceSource open_camera(const ConvertJob& job, const RigCamera& camera) {
  ConvertJob own = job;
  own.in = job.in / camera.name;
  SequenceSource source = open_sequence(own.in, SequenceFormat::tum);
  source.T_body_camera = camera.T_body_camera;
  source.imu = {};
  return fit_to_target(own, std::move(source));
}

/// Opens what a rig's folder has of its body, in the world with z up that EuRoC has or the one that
/// the job asks for. Its camera's fields are not set.
SequenceSource open_body(const ConvertJob& job) {
  SequenceSource body;
  body.up = WorldUp::y;
  body.truth = read_truth(job.in / "groundtruth.txt", TrajectoryFormat::tum, body.notes);
  if (fs::exists(job.in / "imu.csv")) {
    body.imu.samples = read_imu(job.in / "imu.csv");
    body.imu.noise = read_imu_noise(job.in / "imu.toml");
    body.imu.states = read_states(job.in / "truth/imu_states.csv");
  }
  return in_world(std::move(body), job.up == WorldUp::unknown ? traits_of(job.to).up : job.up);
}

/// Returns the note on a camera that is left out, as no pinhole.
std::string note_on_projection(const RigCamera& camera) {
  return concat("camera '", camera.name,
                "' is left out: EuRoC holds pinhole cameras, not projection = ",
                quoted_toml(to_string(camera.camera.model.projection())));
}

/// Adds those words of a list that another does not have yet.
void add_new(const std::vector<std::string>& words, std::vector<std::string>& list) {
  for (const std::string& word : words) {
    if (std::find(list.begin(), list.end(), word) == list.end()) {
      list.push_back(word);
    }
  }
}

/// What of a camera of a rig is written.
struct CameraToWrite {
  std::size_t number = 0;
  const RigCamera& camera;
  SequenceSource source;
};

/// Writes a camera's files, `done` of all cameras' frames being written, and adds to the outcome.
void write_camera(const ConvertJob& job, const CameraToWrite& written, OutputFolder& output,
                  ConvertOutcome& outcome, const std::function<void()>& frame_done) {
  const SequenceSource& source = written.source;
  std::vector<double> depth_stamps;
  DepthImages depth = DepthImages::absent;
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const RgbdFrame frame = source.read(i);
    if (!frame.depth.empty()) {
      depth = DepthImages::present;
      depth_stamps.push_back(depth_timestamp(frame));
      outcome.depth_beyond_16_bit +=
          count_beyond_16_bit(frame.depth, source.camera.depth_units_per_m);
    }
    output.write(encode_euroc_frame(source.camera, frame, written.number));
    frame_done();
  }
  output.write(encode_euroc_camera(source, depth_stamps, written.number));
  add_new(list_dropped(job.to, source, depth), outcome.dropped);
  for (const TruthChannelFiles& channel : truth_channels_in(job.in / written.camera.name)) {
    add_new({"truth/" + channel.name}, outcome.dropped);
  }
  for (const std::string& note : source.notes) {
    outcome.notes.push_back(concat("camera '", written.camera.name, "': ", note));
  }
}

}  // namespace

ConvertOutcome convert_rig(const ConvertJob& job, const OutputPolicy& policy,
                           const Progress& progress) {
  const Rig rig = read_rig(job.in / kRigFile);
  require_convertible(job, rig);
  const SequenceSource body = open_body(job);
  std::vector<CameraToWrite> cameras;
  ConvertOutcome outcome{
      .poses = body.truth.size(), .up = body.up, .imu_samples = body.imu.samples.size()};
  for (const RigCamera& camera : rig.cameras) {
    if (!is_pinhole(camera)) {
      outcome.notes.push_back(note_on_projection(camera));
      continue;
    }
    cameras.push_back({cameras.size(), camera, open_camera(job, camera)});
    outcome.frames += cameras.back().source.timestamps.size();
  }
  std::size_t done = 0;
  OutputFolder output(job.out, policy, [&] { progress(0, 0); });
  for (const CameraToWrite& camera : cameras) {
    write_camera(job, camera, output, outcome, [&] { progress(++done, outcome.frames); });
  }
  output.write(encode_euroc_body(body, rig.T_body_imu));
  output.commit();
  return outcome;
}

}  // namespace vo
