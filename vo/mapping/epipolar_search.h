#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "vo/core/instruction_set.h"
#include "vo/mapping/depth_map_options.h"
#include "vo/mapping/stereo_pair.h"

namespace vo {

/// The outcome of the search for an edge.
enum class SearchOutcome : std::uint8_t {
  found,
  out_of_view,   ///< the line leaves the image
  unobservable,  ///< too little parallax, or the edge runs along the line
  ambiguous,     ///< two places look alike
  no_match,      ///< nothing looks like the edge
};

constexpr auto enum_names(SearchOutcome) {
  return std::array{std::pair{SearchOutcome::found, "found"},
                    std::pair{SearchOutcome::out_of_view, "out_of_view"},
                    std::pair{SearchOutcome::unobservable, "unobservable"},
                    std::pair{SearchOutcome::ambiguous, "ambiguous"},
                    std::pair{SearchOutcome::no_match, "no_match"}};
}

/// An edge pixel of the host and the range of inverse depths in which it is searched.
struct SearchTarget {
  cv::Point pixel;
  cv::Vec2f ray;            ///< (X / Z, Y / Z)
  cv::Vec2f gradient;       ///< gradient of the host's intensity, 1/px
  float inverse_depth = 1;  ///< 1/m, expected
  float nearest = 2;        ///< 1/m, near end of the searched interval
  float farthest = 0;       ///< 1/m, far end of the searched interval
};

struct Observation {
  SearchOutcome outcome = SearchOutcome::unobservable;
  float inverse_depth = 0;  ///< 1/m
  float variance = 0;       ///< 1/m^2, of errors that are independent between frames
  float offset_slope = 0;   ///< 1/m, error from one standard deviation of the host's edge offset
};

/// Returns the squared cosine of the angle between an edge pixel's gradient and its epipolar line
/// in the host, or 0 where there is no line.
float epipolar_cos2(const StereoPair& pair, cv::Point pixel, const cv::Vec2f& gradient);

/// Looks for edges of the host along their epipolar lines in the current image: the least sum of
/// squared differences of five samples one host pixel apart along the line, but for the share of
/// their common offset that is none of the edge's (`kCommonOffset`), refined by
/// Gauss-Newton on the position along the line. The variance of the inverse depth is
///
///   alpha^2 ((s_line^2 + s_pose^2) / cos^2 + s_I^2 / sum dI^2 + s_match^2)
///
/// with alpha the inverse depth per px (Engel, Sturm, Cremers, "Semi-Dense Visual Odometry for a
/// Monocular Camera", ICCV 2013, Eq. 4 to 9), s_pose the pose's uncertainty across the edge and
/// s_I^2 the images' squared difference, the mean of 2 s_grey^2 and what the samples show. The
/// edge's offset in the host moves the match by s_offset / cos in addition. Returns one observation
/// per target, with identical bits for all instruction sets.
std::vector<Observation> search_epipolar_lines(const StereoPair& pair,
                                               const EpipolarOptions& options,
                                               std::span<const SearchTarget> targets,
                                               InstructionSet set = available_instruction_set());

}  // namespace vo
