#include "synth/sequence/denoised_frames.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <tbb/collaborative_call_once.h>
#include <tbb/global_control.h>
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

}  // namespace

/// A noisy frame, rendered once by whoever needs it first.
struct DenoisedFrames::Kept {
  explicit Kept(std::size_t index_of_frame) : index(index_of_frame) {}

  /// Returns a point in the axes of the camera as it is while a row is exposed, m.
  Eigen::Vector3d in_camera(const TrianglePoint& point, int row) const;
  /// Returns where the frame sees a point, by steps from a pixel nearby: of a rolling shutter, the
  /// row of each step tells the time of the next.
  Seen place_of(const TrianglePoint& point, const cv::Point& nearby) const;

  std::size_t index;
  tbb::collaborative_once_flag once;
  Capture capture;
  std::optional<CapturePoses> poses;
  std::shared_ptr<const Renderer> renderer;
  NoisyFrame frame;
};

Eigen::Vector3d DenoisedFrames::Kept::in_camera(const TrianglePoint& point, int row) const {
  const double time = capture.scene_time + capture.shutter.row_time(row, capture.camera.height());
  const CameraPose& pose = poses->of_row(row);
  return pose.R_world_camera.transpose() * (renderer->position(point, time) - pose.position);
}

Seen DenoisedFrames::Kept::place_of(const TrianglePoint& point, const cv::Point& nearby) const {
  constexpr int kSteps = 3;
  const vo::CameraModel& camera = capture.camera;
  Eigen::Vector2d pixel(nearby.x, nearby.y);
  double depth = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double row = std::clamp(pixel.y(), 0.0, camera.height() - 1.0);
    const Eigen::Vector3d p_camera = in_camera(point, static_cast<int>(std::lround(row)));
    if (!camera.sees(p_camera)) {
      return {};
    }
    depth = camera.depth(p_camera);
    pixel = camera.project(p_camera);
  }
  return {{static_cast<float>(pixel.x()), static_cast<float>(pixel.y())}, depth};
}

OtherFrame DenoisedFrames::seen_from(const Kept& here, const Kept& other) {
  constexpr double kOneSurface = 0.03;  // greatest relative difference of nearness in a pixel
  const PointImage& points = here.frame.frame.points;
  OtherFrame result{&other.frame.picture, cv::Mat_<cv::Vec2f>(points.size, kUnseen),
                    cv::Mat_<float>(points.size, 0.0F), other.capture.camera.wraps()};
  for (int v = 0; v < points.size.height; ++v) {
    for (int u = 0; u < points.size.width; ++u) {
      const TrianglePoint& point = points.at(u, v);
      if (!point.exists()) {
        continue;
      }
      const double depth = here.capture.camera.depth(here.in_camera(point, v));
      if (std::abs(here.frame.picture.nearness(v, u) * depth - 1) > kOneSurface) {
        continue;  // The pixel shows surfaces that move differently.
      }
      const Seen seen = other.place_of(point, {u, v});
      result.places(v, u) = seen.pixel;
      result.nearness_ratio(v, u) = static_cast<float>(depth / seen.depth);
    }
  }
  return result;
}

DenoisedFrames::DenoisedFrames(FrameSource source, int reach, std::size_t kept)
    : source_(std::move(source)), reach_(static_cast<std::size_t>(reach)), capacity_(kept) {}

DenoisedFrames::~DenoisedFrames() = default;

std::size_t DenoisedFrames::frames_at_once(int reach) {
  using tbb::global_control;
  const auto threads =
      std::min(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
               global_control::active_value(global_control::max_allowed_parallelism));
  return 2 * static_cast<std::size_t>(reach) + threads + 1;
}

/// Returns the place of a noisy frame, rendered or not, among those that are kept.
std::shared_ptr<DenoisedFrames::Kept> DenoisedFrames::kept(std::size_t index) const {
  std::list<std::shared_ptr<Kept>> released;  // after the lock
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const auto& one) { return one->index == index; });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
  } else {
    kept_.push_front(std::make_shared<Kept>(index));
  }
  if (kept_.size() > capacity_) {
    released.splice(released.begin(), kept_, std::prev(kept_.end()));
  }
  return kept_.front();
}

/// Returns a noisy frame. Those that wait for another thread to render it help its tasks along.
std::shared_ptr<const DenoisedFrames::Kept> DenoisedFrames::noisy(std::size_t index) const {
  const std::shared_ptr<Kept> frame = kept(index);
  tbb::collaborative_call_once(frame->once, [&] {
    frame->capture = source_.capture(index);
    frame->capture.channels.color = false;  // which the picture has
    frame->capture.channels.points = true;
    frame->poses.emplace(frame->capture);
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
  NoisyFrame mixed = {here->frame.frame, with_light_of(here->frame.picture, others)};
  return {without_noise(std::move(mixed), here->capture), here->renderer};
}

}  // namespace synth
