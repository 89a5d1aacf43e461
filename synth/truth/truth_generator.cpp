#include "synth/truth/truth_generator.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "synth/ray_tracing/point_tracer.h"
#include "synth/ray_tracing/ray_tracer.h"
#include "synth/ray_tracing/surface_tracer.h"
#include "synth/scene/scene_motion.h"
#include "synth/truth/motion_truth.h"
#include "synth/truth/pixel_truth.h"
#include "synth/truth/stereo_truth.h"
#include "vo/core/fields.h"
#include "vo/image_files/flow_file.h"
#include "vo/image_files/png.h"

namespace synth {

/// The scene at one time, with its tracers.
class TruthGenerator::Instant {
 public:
  Instant(const TruthSubject& subject, const TruthOptions& options, double time)
      : moved_(moves(subject.scene) ? std::optional(scene_at(subject.scene, time)) : std::nullopt),
        scene_(moved_ ? *moved_ : subject.scene),
        tracer_(scene_) {
    if (options.has(TruthChannel::edges)) {
      surfaces_ = std::make_unique<const SurfaceTracer>(scene_, subject.ambient);
    }
    if (options.has(TruthChannel::depth_beyond)) {
      renderer_ = make_ray_tracer(scene_, {.mode = RenderMode::depth});
    }
  }

  const PointTracer& tracer() const { return tracer_; }
  const SurfaceTracer& surfaces() const { return *surfaces_; }  ///< requires TruthChannel::edges

  /// Requires TruthChannel::depth_beyond.
  vo::DepthImage depth_beyond(const vo::CameraModel& camera, const vo::SE3& T_world_camera) const {
    Capture capture = still(camera, T_world_camera);
    capture.channels = {.color = false, .depth = false, .sight = true};
    return renderer_->render(capture).sight.beyond;
  }

 private:
  std::optional<Scene> moved_;
  const Scene& scene_;
  PointTracer tracer_;
  std::unique_ptr<const SurfaceTracer> surfaces_;
  std::unique_ptr<const Renderer> renderer_;
};

namespace {

/// Returns the frame to which flow and motion lead: the next one, or for the last the one before.
std::size_t neighbour(std::size_t index, std::size_t frames) {
  return index + 1 < frames ? index + 1 : std::max<std::size_t>(index, 1) - 1;
}

}  // namespace

/// The inputs from which the channels of a frame are made.
struct TruthGenerator::Frame {
  const Instant& now;
  const Instant& other;
  vo::SE3 T_world_camera;
  vo::SE3 T_world_other;
  PointImage points;
};

TruthGenerator::TruthGenerator(const TruthSubject& subject, const TruthOptions& options)
    : subject_(subject), options_(options) {
  options.validate();
  if (!moves(subject.scene)) {
    still_ = std::make_shared<const Instant>(subject, options, 0);
  }
}

TruthGenerator::~TruthGenerator() = default;

std::shared_ptr<const TruthGenerator::Instant> TruthGenerator::instant(std::size_t index) const {
  return still_ ? still_
                : std::make_shared<const Instant>(
                      subject_, options_,
                      scene_time(subject_.trajectory, subject_.trajectory[index].timestamp) +
                          subject_.scene_delay);
}

std::string TruthGenerator::encode(const Frame& frame, TruthChannel channel) const {
  const PointTracer& tracer = frame.now.tracer();
  const PointTracer& other = frame.other.tracer();
  const NextView next{other, subject_.camera, frame.T_world_other};
  switch (channel) {
    case TruthChannel::depth:
      return vo::encode_float_image(depth_truth(frame.points), options_.float_format);
    case TruthChannel::normal:
      return vo::encode_float_image(
          normal_truth(frame.points, tracer, frame.T_world_camera.translation()),
          options_.float_format);
    case TruthChannel::instance:
      return vo::encode_png(instance_truth(frame.points, tracer.scene()));
    case TruthChannel::material:
      return vo::encode_png(material_truth(frame.points, tracer.scene()));
    case TruthChannel::surface_class:
      return vo::encode_png(class_truth(frame.points, tracer.scene(), subject_.instance_classes));
    case TruthChannel::flow:
      return vo::encode_flow(optical_flow(frame.points, next));
    case TruthChannel::occlusion:
      return vo::encode_png(occlusion(frame.points, next));
    case TruthChannel::edges:
      return vo::encode_png(
          edge_labels(frame.now.surfaces().trace(subject_.camera, frame.T_world_camera),
                      subject_.camera, options_.edges));
    case TruthChannel::moving:
      return vo::encode_png(moved_points(frame.points, tracer, other));
    case TruthChannel::disparity:
      return vo::encode_float_image(
          disparity_truth(frame.points, subject_.camera.pinhole_for("channels: disparity").fx *
                                            options_.stereo_baseline),
          options_.float_format);
    case TruthChannel::stereo_occlusion:
      return vo::encode_png(
          occlusion(frame.points, {tracer, subject_.camera,
                                   frame.T_world_camera * T_left_right(options_.stereo_baseline)}));
    case TruthChannel::depth_beyond:
      return vo::encode_float_image(frame.now.depth_beyond(subject_.camera, frame.T_world_camera),
                                    options_.float_format);
    case TruthChannel::velocity:
    case TruthChannel::imu:
      break;
  }
  return "";
}

std::vector<vo::NamedBytes> TruthGenerator::make(std::size_t index) const {
  const vo::Trajectory& trajectory = subject_.trajectory;
  const std::vector<TruthFile> names = truth_files(options_, index, trajectory.size());
  if (names.empty()) {
    return {};
  }
  const std::size_t other = neighbour(index, trajectory.size());
  const auto now = instant(index);
  const auto then = instant(other);
  const vo::SE3& T_world_camera = trajectory.at(index).T_world_camera;
  const Frame frame{*now, *then, T_world_camera, trajectory[other].T_world_camera,
                    now->tracer().trace(subject_.camera, T_world_camera)};
  std::vector<vo::NamedBytes> files;
  for (const auto& [channel, name] : names) {
    files.push_back({name, encode(frame, channel)});
  }
  return files;
}

}  // namespace synth
