#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vo/image/pyramid.h"
#include "vo/mapping/depth_map_options.h"

namespace vo {

/// What is known of one edge pixel's depth.
enum class DepthState : std::uint8_t {
  none,       ///< a guess; the whole range of depths is searched
  tentative,  ///< found once in the whole range; the next observation must confirm it
  filled,     ///< taken from neighbours
  known,      ///< observed or given
};

/// The depth of edge pixels of one frame, the host: one element per pixel in each array, in scan
/// order. Depth is that of the edge, not of the background beside it.
///
/// Every observation compares with the same five samples of the host: what the host shows
/// wrongly, as by aliasing, is the same in all of them and does not average away. This offset of
/// the edge is estimated beside the inverse depth, in units of its standard deviation.
struct Hypotheses {
  std::vector<cv::Point> pixel;     ///< px
  std::vector<cv::Vec2f> ray;       ///< (X / Z, Y / Z)
  std::vector<cv::Vec2f> gradient;  ///< of the intensity at the pixel, 1/px
  std::vector<cv::Vec2f> across;    ///< its direction, unit
  std::vector<float> edge_offset;   ///< px, from the pixel's centre to the edge up the gradient
  std::vector<DepthState> state;
  std::vector<float> inverse_depth;      ///< 1/m
  std::vector<float> variance;           ///< 1/m^2
  std::vector<float> offset;             ///< of the edge in the host, standard deviations
  std::vector<float> offset_variance;    ///< 1 where nothing is known of it
  std::vector<float> offset_covariance;  ///< with the inverse depth, 1/m
  std::vector<float> smoothed;           ///< 1/m, inverse depth agreed with the neighbours
  std::vector<float> smoothed_variance;  ///< 1/m^2, of that
  std::vector<float> inliers;            ///< successful observations; a of Beta(a, b)
  std::vector<float> outliers;           ///< failed ones; b of Beta(a, b)
  std::vector<int> previous;             ///< neighbour along the edge, -1 without
  std::vector<int> next;                 ///< the one on the other side
  cv::Mat_<int> index;                   ///< of each pixel of the host, -1 where none

  std::size_t size() const { return pixel.size(); }

  /// Of the smoothed inverse depth.
  float relative_sigma(std::size_t i) const {
    return std::sqrt(smoothed_variance[i]) / smoothed[i];
  }

  /// Given, confirmed or filled in.
  bool is_trusted(std::size_t i) const {
    return state[i] == DepthState::filled || state[i] == DepthState::known;
  }

  bool is_confident(std::size_t i, double max_relative_sigma) const {
    return is_trusted(i) && relative_sigma(i) <= max_relative_sigma;
  }

  /// The edge in the image, px.
  cv::Vec2f edge_position(std::size_t i) const;

  void set(std::size_t i, float new_inverse_depth, float new_variance);  ///< known, not yet tried
  void forget(std::size_t i, float guess);  ///< back to a guess of the inverse depth, 1/m
};

/// Edge pixels of a frame's finest level, at most as many as the options say, linked along the
/// edges; nothing is known of their depth and the guess is the same for all.
Hypotheses edge_hypotheses(const PyramidLevel& level, const DepthMapOptions& options,
                           float guessed_inverse_depth);

/// The median inverse depth of the hypotheses that are known; the fallback where there are none.
float median_inverse_depth(const Hypotheses& hypotheses, float fallback);

}  // namespace vo
