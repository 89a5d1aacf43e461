#include "vo/odometry/rgbd_odometry.h"

#include <algorithm>
#include <numbers>

#include "vo/core/error.h"
#include "vo/core/stopwatch.h"
#include "vo/image/fingerprint.h"
#include "vo/image/moved_depth.h"
#include "vo/tracking/tracker.h"

namespace vo {
namespace {

TrackerOptions paper_options() {
  TrackerOptions options;
  options.pyramid.levels = 3;
  options.edges.threshold = EdgeThreshold::otsu;
  options.points.source = EdgeSource::current;
  options.keyframes.every = 1;
  options.map.max_keyframes = 1;
  options.lens = LensModel::ignore;
  return options;
}

/// Returns the options of github.com/kevinchristensen1/EdgeDirectVO as released: their weights
/// enter the normal equations squared, a step that raised the error is kept, the principal point is
/// halved without the half pixel, depth is resized across its holes, and every third frame is a
/// keyframe.
TrackerOptions authors_options() {
  TrackerOptions options = paper_options();
  options.pyramid.principal_point = HalvedPrincipalPoint::plain;
  options.pyramid.depth = HalvedDepth::cubic;
  options.align.squared_weights = true;
  options.align.keep_worse_step = true;
  options.align.max_iterations = 20;
  options.align.min_translation = 1e-4;
  options.align.min_rotation_deg = 1e-4 * 180 / std::numbers::pi;
  options.keyframes.every = 3;
  return options;
}

/// Returns the options that measured best; docs/results.md shows what each of these is worth.
TrackerOptions best_options() {
  TrackerOptions options;
  options.pyramid.levels = 5;
  options.points.max_points = 2000;
  options.points.coarser_share = 0.55;
  options.points.discontinuity_radius = 1;
  options.align.step_limit_growth = 5;
  options.align.last_step = 10;
  options.align.secant = true;
  options.align.coarse_references = 2;
  options.align.formulation = Formulation::esm;
  options.align.loss = RobustLoss::student_t;
  options.align.scale = LossScale::residuals;
  options.align.brightness = BrightnessModel::affine;
  options.align.depth_term = 0.4;
  options.keyframes = {.every = 0, .max_flow = 0.06, .min_sharpness = 0.85};
  options.map.references = 4;
  options.lost = {.min_depth_agreement = 0.45, .recover = true};
  options.symmetric = true;
  options.motion_model = MotionModel::best;
  options.shutter = ShutterModel::estimated;
  options.vignette = VignetteModel::estimated;
  options.depth_time = DepthTime::own;
  options.doubt = true;
  return options;
}

/// Returns whether any pixel has a depth; it looks no farther than the first that has.
bool is_measured(const DepthImage& depth) {
  return std::any_of(depth.begin(), depth.end(), has_depth);
}

}  // namespace

PinholeCamera tracked_camera(const PinholeCamera& camera, LensModel lens) {
  constexpr int kMinSize = 4;  // px, size of the neighbourhood that intensities are looked up in
  camera.validate();
  require(camera.width >= kMinSize && camera.height >= kMinSize,
          "odometry: expected a camera of at least ", kMinSize, "x", kMinSize, " px, got ",
          camera.width, "x", camera.height);
  return lens == LensModel::ignore ? camera.without_distortion() : camera;
}

TrackerOptions preset_options(TrackerPreset preset) {
  switch (preset) {
    case TrackerPreset::paper:
      return paper_options();
    case TrackerPreset::authors:
      return authors_options();
    default:
      return best_options();
  }
}

RgbdOdometry::RgbdOdometry(const PinholeCamera& camera, const TrackerOptions& options,
                           const SE3& T_world_first)
    : camera_(tracked_camera(camera, options.lens)),
      options_(options),
      pyramid_builder_(camera_, options.pyramid),
      edge_finder_(options.edges),
      tracker_(std::make_unique<Tracker>(options, T_world_first)) {}

RgbdOdometry::RgbdOdometry(RgbdOdometry&& other) noexcept = default;
RgbdOdometry& RgbdOdometry::operator=(RgbdOdometry&& other) noexcept = default;
RgbdOdometry::~RgbdOdometry() = default;

/// Returns a frame's depth as it was when the image was taken: the camera keeps its velocity. The
/// given depth is that where the stamps are the same or the velocity is not known.
DepthImage RgbdOdometry::depth_at_image_time(const RgbdFrame& frame) {
  const std::optional<Vector6d> velocity = tracker_->expected_velocity();
  if (options_.depth_time == DepthTime::image || frame.depth_delay == 0 || !velocity) {
    return frame.depth;
  }
  PyramidLevel& finest = current_.levels.front();
  finest.depth.release();  // so that its memory can be used again
  move_depth(frame.depth, finest.camera, finest.rays, SE3::exp(frame.depth_delay * *velocity),
             moved_depth_);
  return moved_depth_;
}

TrackingResult RgbdOdometry::track(const RgbdFrame& frame) {
  const cv::Size expected(camera_.width, camera_.height);
  require(frame.image.size() == expected && frame.depth.size() == expected,
          "odometry: expected image and depth of the camera's ", camera_.width, "x", camera_.height,
          " px");
  Stopwatch watch;
  RgbdFrame at_image_time = frame;
  at_image_time.depth = depth_at_image_time(frame);
  pyramid_builder_.build(at_image_time, tracker_->vignette(), current_);
  if (options_.doubt) {
    current_.image_fingerprint = fingerprint(frame.image);
    current_.depth_fingerprint = is_measured(frame.depth) ? fingerprint(frame.depth) : 0;
  }
  stage_times_.pyramid_ms = watch.lap_ms();
  add_edges(current_, edge_finder_);
  stage_times_.edges_ms = watch.lap_ms();

  TrackingResult result = tracker_->track(current_);
  stage_times_.alignment_ms = watch.lap_ms();
  if (tracker_->needs_keyframe(current_, result)) {
    tracker_->set_keyframe(current_, result.T_world_camera);
    result.T_world_camera = tracker_->map().last()->T_world_keyframe;
    result.is_keyframe = true;
  }
  if (result.status != TrackingStatus::lost) {
    trajectory_.push_back({frame.timestamp, result.T_world_camera});
  }
  return result;
}

}  // namespace vo
