#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vo/image/pyramid.h"
#include "vo/mapping/depth_map_options.h"

namespace vo {

/// The state of knowledge of an edge pixel's depth.
enum class DepthState : std::uint8_t {
  none,       ///< the depth is a guess; the whole range of depths is searched
  tentative,  ///< found once in the whole range; the next observation must confirm it
  filled,     ///< the depth was taken from neighbours
  known,      ///< the depth was observed or given
};

/// The depths of the edge pixels of one frame, the host: one element per pixel in each array, in
/// scan order. Each is the depth of the edge, not of the background beside it.
///
/// Every observation compares with the same five samples of the host, whose errors, as by aliasing,
/// are common to all observations and do not average out. The resulting offset of the edge is
/// estimated beside the inverse depth, in units of its standard deviation.
struct Hypotheses {
  std::vector<cv::Point> pixel;     ///< px
  std::vector<cv::Vec2f> ray;       ///< (X / Z, Y / Z)
  std::vector<cv::Vec2f> gradient;  ///< intensity gradient at the pixel, 1/px
  std::vector<cv::Vec2f> across;    ///< unit direction of the gradient
  std::vector<float> edge_offset;   ///< px, from the pixel's centre to the edge up the gradient
  std::vector<DepthState> state;
  std::vector<float> inverse_depth;      ///< 1/m
  std::vector<float> variance;           ///< 1/m^2
  std::vector<float> offset;             ///< edge's offset in the host, standard deviations
  std::vector<float> offset_variance;    ///< variance of offset; 1 where nothing is known
  std::vector<float> offset_covariance;  ///< covariance of offset and inverse depth, 1/m
  std::vector<float> smoothed;           ///< 1/m, inverse depth smoothed along the edge
  std::vector<float> smoothed_variance;  ///< 1/m^2, variance of smoothed
  std::vector<float> inliers;            ///< successful observations; a of Beta(a, b) less prior
  std::vector<float> outliers;           ///< failed observations; b of Beta(a, b) less its prior
  std::vector<int> previous;             ///< index of a neighbour along the edge, -1 without
  std::vector<int> next;                 ///< index of the neighbour on the other side, -1 without
  cv::Mat_<int> index;                   ///< hypothesis at each pixel of the host, -1 where none

  std::size_t size() const { return pixel.size(); }

  /// Returns the relative standard deviation of the smoothed inverse depth.
  float relative_sigma(std::size_t i) const {
    return std::sqrt(smoothed_variance[i]) / smoothed[i];
  }

  /// Returns whether the depth was given, confirmed or filled in.
  bool is_trusted(std::size_t i) const {
    return state[i] == DepthState::filled || state[i] == DepthState::known;
  }

  bool is_confident(std::size_t i, double max_relative_sigma) const {
    return is_trusted(i) && relative_sigma(i) <= max_relative_sigma;
  }

  /// Returns the edge's position in the image, px.
  cv::Vec2f edge_position(std::size_t i) const;

  void set(std::size_t i, float new_inverse_depth, float new_variance);  ///< known, unobserved
  void forget(std::size_t i, float guess);                               ///< back to a guess, 1/m
};

/// Returns the edge pixels of a frame's finest level, at most about as many as the options say,
/// linked along the edges. All depths are unknown, with one guess, 1/m.
Hypotheses edge_hypotheses(const PyramidLevel& level, const DepthMapOptions& options,
                           float guessed_inverse_depth);

/// Returns the median inverse depth of the hypotheses that are not guesses, or else the fallback.
float median_inverse_depth(const Hypotheses& hypotheses, float fallback);

}  // namespace vo
