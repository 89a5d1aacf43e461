#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "tools/bench/peer.h"

namespace tools {

/// Dense RGB-D odometry of OpenCV's contrib modules. With the parameters OpenCV gives it, it aligns
/// a random 7 % of the pixels at most.
enum class OpencvOdometry {
  rgbd,      ///< cv::rgbd::RgbdOdometry: photometric
  rgbd_all,  ///< the same with every pixel that has depth and a gradient
  rgbd_icp,  ///< cv::rgbd::RgbdICPOdometry: photometric and geometric
};

constexpr auto enum_names(OpencvOdometry) {
  return std::array{std::pair{OpencvOdometry::rgbd, "opencv-rgbd"},
                    std::pair{OpencvOdometry::rgbd_all, "opencv-rgbd-all"},
                    std::pair{OpencvOdometry::rgbd_icp, "opencv-rgbd-icp"}};
}

/// Frame to frame, as OpenCV's sample does it; each frame's pyramid is made once. It knows no lens
/// distortion. Nothing where this program was built without the module.
std::optional<Peer> opencv_peer(OpencvOdometry kind);

}  // namespace tools
