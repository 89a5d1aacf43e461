#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "tools/bench/peer.h"

namespace tools {

/// Variants of the dense RGB-D odometry in OpenCV's contrib modules. With its default parameters it
/// aligns a random 7 % of the pixels at most.
enum class OpencvOdometry {
  rgbd,      ///< cv::rgbd::RgbdOdometry: photometric
  rgbd_all,  ///< photometric, every pixel that has depth and a gradient
  rgbd_icp,  ///< cv::rgbd::RgbdICPOdometry: photometric and geometric
};

constexpr auto enum_names(OpencvOdometry) {
  return std::array{std::pair{OpencvOdometry::rgbd, "opencv-rgbd"},
                    std::pair{OpencvOdometry::rgbd_all, "opencv-rgbd-all"},
                    std::pair{OpencvOdometry::rgbd_icp, "opencv-rgbd-icp"}};
}

/// Returns a peer that tracks frame to frame, as OpenCV's sample does, builds each frame's pyramid
/// once and ignores lens distortion. It is empty if this program was built without the module.
std::optional<Peer> opencv_peer(OpencvOdometry kind);

}  // namespace tools
