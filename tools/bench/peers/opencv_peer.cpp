#include "tools/bench/opencv_peer.h"

#include <limits>
#include <memory>

#include <opencv2/imgproc.hpp>
#include <opencv2/rgbd/depth.hpp>

#include "vo/core/fields.h"
#include "vo/core/stopwatch.h"

namespace tools {
namespace {

using cv::rgbd::OdometryFrame;

cv::Mat intrinsics(const vo::PinholeCamera& camera) {
  return cv::Mat_<double>({3, 3}, {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1});
}

cv::Ptr<cv::rgbd::Odometry> make_odometry(OpencvOdometry kind, const vo::PinholeCamera& camera) {
  if (kind == OpencvOdometry::rgbd_icp) {
    return cv::rgbd::RgbdICPOdometry::create(intrinsics(camera));
  }
  cv::Ptr<cv::rgbd::RgbdOdometry> odometry = cv::rgbd::RgbdOdometry::create(intrinsics(camera));
  if (kind == OpencvOdometry::rgbd_all) {
    odometry->setMaxPointsPart(1);
  }
  return odometry;
}

vo::SE3 to_se3(const cv::Mat_<double>& T) {
  Eigen::Matrix3d R;
  R << T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2);
  return {Eigen::Quaterniond(R), {T(0, 3), T(1, 3), T(2, 3)}};
}

/// Returns the depth with NaN, as OpenCV expects, where a pixel has none.
cv::Mat with_nan_holes(const vo::DepthImage& depth) {
  cv::Mat result = depth.clone();
  result.setTo(std::numeric_limits<float>::quiet_NaN(), depth == 0);
  return result;
}

class OpencvTracker {
 public:
  OpencvTracker(OpencvOdometry kind, const vo::PinholeCamera& camera)
      : odometry_(make_odometry(kind, camera)) {}

  FrameSample track(const vo::RgbdFrame& frame) {
    const cv::Mat depth = with_nan_holes(frame.depth);  // not timed: it only converts the input
    FrameSample sample;
    const vo::CpuStopwatch cpu_watch;
    vo::Stopwatch watch;
    cv::Ptr<OdometryFrame> current = OdometryFrame::create(gray(frame.image), depth);
    odometry_->prepareFrameCache(current, OdometryFrame::CACHE_ALL);
    sample.costs.pyramid_ms = watch.lap_ms();
    const bool tracked = !last_ || advance(current);
    sample.costs.alignment_ms = watch.lap_ms();
    sample.cpu_ms = cpu_watch.elapsed_ms();
    if (tracked) {
      sample.T_world_camera = T_world_last_;
    }
    sample.is_keyframe = true;
    sample.points = static_cast<std::size_t>(cv::countNonZero(current->pyramidTexturedMask[0]));
    last_ = current;
    return sample;
  }

 private:
  static cv::Mat gray(const cv::Mat& image) {
    cv::Mat result = image;
    if (image.channels() == 3) {
      cv::cvtColor(image, result, cv::COLOR_BGR2GRAY);
    }
    return result;
  }

  bool advance(cv::Ptr<OdometryFrame>& current) {
    cv::Mat T_last_cur;
    const bool tracked = odometry_->compute(current, last_, T_last_cur);
    if (tracked) {
      T_world_last_ = T_world_last_ * to_se3(T_last_cur);
    }
    return tracked;
  }

  cv::Ptr<cv::rgbd::Odometry> odometry_;
  cv::Ptr<OdometryFrame> last_;
  vo::SE3 T_world_last_;
};

}  // namespace

std::optional<Peer> opencv_peer(OpencvOdometry kind) {
  return Peer{std::string(vo::to_string(kind)), [kind](const vo::PinholeCamera& camera) {
                const auto tracker = std::make_shared<OpencvTracker>(kind, camera);
                return [tracker](const vo::RgbdFrame& frame) { return tracker->track(frame); };
              }};
}

}  // namespace tools
