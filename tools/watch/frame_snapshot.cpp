#include "tools/watch/frame_snapshot.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

#include "tools/pictures/pictures.h"
#include "tools/pictures/webp.h"
#include "vo/image_files/png.h"

namespace tools {
namespace {

constexpr int kMaxWidth = 320;  // px
constexpr double kMapQuality = 60;

/// Returns the values at two shares of the order of all.
std::array<double, 2> range_of(std::vector<float> values, double low, double high) {
  const auto at = [&](double share) {
    const auto nth = values.begin() +
                     static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return static_cast<double>(*nth);
  };
  return {at(low), at(high)};
}

/// Draws the inverse depths as dots on the host's darkened image.
ValuePicture draw_map(const MapSnapshot& map) {
  constexpr double kDarkened = 0.45;
  cv::Mat_<uchar> grey;
  map.host.convertTo(grey, CV_8U, 255 * kDarkened);
  cv::Mat_<cv::Vec3b> picture = as_picture(grey);
  const std::array<double, 2> range = range_of(map.inverse_depths, 0.05, 0.95);
  const cv::Mat_<float> values(map.inverse_depths, true);
  const cv::Mat_<cv::Vec3b> colours = draw_values(values, range);
  const double scale = static_cast<double>(picture.cols) / map.size.width;
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    const cv::Point at(cvFloor(scale * map.pixels[i].x), cvFloor(scale * map.pixels[i].y));
    picture(cv::Rect(at, cv::Size(2, 2)) & cv::Rect({0, 0}, picture.size()))
        .setTo(colours(static_cast<int>(i), 0));
  }
  return {encode_webp(picture, kMapQuality), range};
}

}  // namespace

FrameSnapshot snapshot_of(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                          const vo::Tracker& tracker, const vo::TrackingResult& result) {
  const std::size_t index = level_that_fits(pyramid, kMaxWidth);
  const vo::PyramidLevel& level = pyramid.levels[index];
  return {.frame = frame,
          .level = {.camera = level.camera,
                    .rays = level.rays,
                    .intensity = level.intensity.clone(),
                    .edges = level.edges.clone(),
                    .depth = level.depth.clone()},
          .points = aligned_points(tracker, result, index),
          .result = result,
          .map = std::nullopt};
}

std::optional<MapSnapshot> snapshot_of(const vo::DepthMap& map) {
  if (map.empty() || map.confident() == 0) {
    return std::nullopt;
  }
  const std::size_t index = level_that_fits(map.host(), kMaxWidth);
  MapSnapshot snapshot{.host = map.host().levels[index].intensity.clone(),
                       .size = map.host().levels.front().intensity.size(),
                       .pixels = {},
                       .inverse_depths = {}};
  const vo::Hypotheses& hypotheses = map.hypotheses();
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.is_confident(i, vo::kConfidentSigma)) {
      snapshot.pixels.push_back(hypotheses.pixel[i]);
      snapshot.inverse_depths.push_back(hypotheses.smoothed[i]);
    }
  }
  return snapshot;
}

FramePictures draw(const FrameSnapshot& snapshot) {
  FramePictures pictures =
      draw_frame(snapshot.frame, snapshot.level, snapshot.points, snapshot.result);
  if (snapshot.map) {
    pictures.inverse_depth = draw_map(*snapshot.map);
  }
  return pictures;
}

FramePictures draw(const RenderedFrame& frame) {
  constexpr double kQuality = 50;
  const cv::Mat image = vo::decode_png(frame.image, "rendered image");
  const cv::Mat depth = vo::decode_png(frame.depth, "rendered depth");
  FramePictures pictures;
  const double scale = std::min(1.0, static_cast<double>(kMaxWidth) / image.cols);
  pictures.size = cv::Size(cvRound(scale * image.cols), cvRound(scale * image.rows));
  pictures.colour = encode_webp(resized_picture(image, pictures.size), kQuality);
  cv::Mat_<float> meters;
  depth.convertTo(meters, CV_32F, 1 / frame.depth_units_per_m);
  cv::resize(meters, meters, pictures.size, 0, 0, cv::INTER_NEAREST);
  const auto [nearest, farthest] = positive_range(meters);
  if (farthest > 0) {
    pictures.depth = encoded_values(meters, {farthest, nearest});
  }
  return pictures;
}

}  // namespace tools
