#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "tools/pictures/frame_pictures.h"
#include "vo/core/image.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/mapping/depth_map.h"
#include "vo/tracking/tracker.h"
#include "vo/tracking/tracking_result.h"

namespace tools {

/// What of a monocular map is drawn: its confident inverse depths on the host's image.
struct MapSnapshot {
  vo::GrayImage host;
  cv::Size size;  ///< px, in which the pixels count
  std::vector<cv::Point> pixels;
  std::vector<float> inverse_depths;  ///< 1/m
};

/// What pictures of a frame are drawn from, in memory of its own, so that another thread can draw
/// while the tracker goes on.
struct FrameSnapshot {
  vo::RgbdFrame frame;
  vo::PyramidLevel level;  ///< level of the frame's pyramid that is drawn
  vo::EdgePointLevel points;
  vo::TrackingResult result;
  std::optional<MapSnapshot> map;
};

/// Takes a snapshot of a tracked frame: it copies one level of the pyramid.
FrameSnapshot snapshot_of(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                          const vo::Tracker& tracker, const vo::TrackingResult& result);

/// Takes a snapshot of a map; none of an empty one.
std::optional<MapSnapshot> snapshot_of(const vo::DepthMap& map);

/// Draws the pictures of a snapshot.
FramePictures draw(const FrameSnapshot& snapshot);

/// A rendered frame as its files hold it.
struct RenderedFrame {
  std::string image;  ///< PNG
  std::string depth;  ///< PNG of 16 bits
  double depth_units_per_m = 0;
};

/// Draws a rendered frame. Throws vo::Error where its files cannot be decoded.
FramePictures draw(const RenderedFrame& frame);

}  // namespace tools
