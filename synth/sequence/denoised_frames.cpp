#include "synth/sequence/denoised_frames.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <tbb/collaborative_call_once.h>
#include <tbb/task_arena.h>

namespace synth {
namespace {

const cv::Vec2f kUnseen(std::numeric_limits<float>::quiet_NaN(),
                        std::numeric_limits<float>::quiet_NaN());

/// Where a capture sees a point.
struct Seen {
  cv::Vec2f pixel = kUnseen;
  double depth = 1;  ///< m, CameraModel::depth
};

Eigen::Vector3d in_camera(const CameraPose& pose, const Eigen::Vector3d& p_world) {
  return pose.R_world_camera.transpose() * (p_world - pose.position);
}

/// Returns where a capture sees a point, by steps from a pixel nearby: of a rolling shutter, the
/// row of each step tells the pose of the next.
Seen seen_by(const Capture& capture, const CapturePoses& poses, const cv::Point& nearby,
             const Eigen::Vector3d& p_world) {
  constexpr int kSteps = 3;
  const vo::CameraModel& camera = capture.camera;
  Eigen::Vector2d pixel(nearby.x, nearby.y);
  double depth = 0;
  for (int i = 0; i < kSteps; ++i) {
    const auto row = static_cast<int>(std::clamp(pixel.y(), 0.0, camera.height() - 1.0) + 0.5);
    const Eigen::Vector3d p_camera = in_camera(poses.of_row(row), p_world);
    if (!camera.sees(p_camera)) {
      return {};
    }
    depth = camera.depth(p_camera);
    pixel = camera.project(p_camera);
  }
  return {{static_cast<float>(pixel.x()), static_cast<float>(pixel.y())}, depth};
}

}  // namespace

/// A noisy frame, rendered once by whoever needs it first.
struct DenoisedFrames::Kept {
  explicit Kept(std::size_t index_of_frame) : index(index_of_frame) {}

  std::size_t index;
  tbb::collaborative_once_flag once;
  Capture capture;
  std::shared_ptr<const Renderer> renderer;
  NoisyFrame frame;
};

OtherFrame DenoisedFrames::seen_from(const Kept& here, const Kept& other) {
  const PointImage& points = here.frame.frame.points;
  OtherFrame result{&other.frame.picture, cv::Mat_<cv::Vec2f>(points.size, kUnseen),
                    cv::Mat_<float>(points.size, 0.0F), other.capture.camera.wraps()};
  const CapturePoses poses_here(here.capture);
  const CapturePoses poses_there(other.capture);
  for (int v = 0; v < points.size.height; ++v) {
    for (int u = 0; u < points.size.width; ++u) {
      const TrianglePoint& point = points.at(u, v);
      if (!point.exists()) {
        continue;
      }
      const Eigen::Vector3d p_camera =
          in_camera(poses_here.of_row(v), here.renderer->position(point));
      const Seen seen =
          seen_by(other.capture, poses_there, {u, v}, other.renderer->position(point));
      result.places(v, u) = seen.pixel;
      result.nearness_ratio(v, u) =
          static_cast<float>(here.capture.camera.depth(p_camera) / seen.depth);
    }
  }
  return result;
}

DenoisedFrames::DenoisedFrames(FrameSource source, int reach)
    : source_(std::move(source)), reach_(static_cast<std::size_t>(reach)) {}

DenoisedFrames::~DenoisedFrames() = default;

/// Returns the place of a noisy frame, rendered or not, among those that are kept.
std::shared_ptr<DenoisedFrames::Kept> DenoisedFrames::kept(std::size_t index) const {
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const auto& one) { return one->index == index; });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
  } else {
    kept_.push_front(std::make_shared<Kept>(index));
  }
  kept_.resize(std::min(kept_.size(), (2 * reach_ + 2) * threads));
  return kept_.front();
}

/// Returns a noisy frame. Those that wait for another thread to render it help its tasks along.
std::shared_ptr<const DenoisedFrames::Kept> DenoisedFrames::noisy(std::size_t index) const {
  const std::shared_ptr<Kept> frame = kept(index);
  tbb::collaborative_call_once(frame->once, [&] {
    frame->capture = source_.capture(index);
    frame->capture.channels.points = true;
    frame->renderer = source_.renderer(index);
    frame->frame = frame->renderer->render_noisy(frame->capture);
  });
  return frame;
}

DenoisedFrame DenoisedFrames::render(std::size_t index) const {
  const std::shared_ptr<const Kept> here = noisy(index);
  const std::size_t first = index - std::min(index, reach_);
  const std::size_t last = std::min(index + reach_, source_.count - 1);
  std::vector<std::shared_ptr<const Kept>> around;  // which own the pictures of `others`
  std::vector<OtherFrame> others;
  for (std::size_t i = first; i <= last; ++i) {
    if (i != index) {
      around.push_back(noisy(i));
      others.push_back(seen_from(*here, *around.back()));
    }
  }
  NoisyFrame helped = {here->frame.frame, with_light_of(here->frame.picture, others)};
  return {without_noise(std::move(helped), here->capture), here->renderer};
}

}  // namespace synth
