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

/// What came of looking for an edge.
enum class SearchOutcome : std::uint8_t {
  found,
  out_of_view,   ///< the line leaves the image
  unobservable,  ///< too little parallax, or the edge runs along the line
  ambiguous,     ///< two places look alike
  no_match,      ///< nothing looks like it
};

constexpr auto enum_names(SearchOutcome) {
  return std::array{std::pair{SearchOutcome::found, "found"},
                    std::pair{SearchOutcome::out_of_view, "out_of_view"},
                    std::pair{SearchOutcome::unobservable, "unobservable"},
                    std::pair{SearchOutcome::ambiguous, "ambiguous"},
                    std::pair{SearchOutcome::no_match, "no_match"}};
}

/// An edge pixel of the host and where its depth is looked for.
struct SearchTarget {
  cv::Point pixel;
  cv::Vec2f ray;            ///< (X / Z, Y / Z)
  cv::Vec2f gradient;       ///< 1/px
  float inverse_depth = 1;  ///< 1/m, expected
  float nearest = 2;        ///< 1/m, end of the searched interval
  float farthest = 0;       ///< 1/m, the other end
};

struct Observation {
  SearchOutcome outcome = SearchOutcome::unobservable;
  float inverse_depth = 0;  ///< 1/m
  float variance = 0;       ///< 1/m^2, of what differs from frame to frame
  float offset_slope = 0;   ///< 1/m, error from one standard deviation of the host's edge offset
};

/// Squared cosine of the angle between an edge pixel's gradient and its epipolar line in the
/// host; 0 where there is no line.
float epipolar_cos2(const StereoPair& pair, cv::Point pixel, const cv::Vec2f& gradient);

/// Looks for edges of the host along their epipolar lines in the current image: five samples one
/// host pixel apart along the line, the least sum of squared differences, and Gauss-Newton on the
/// position along the line. The variance is
///
///   alpha^2 ((s_line^2 + s_pose^2) / cos^2 + s_I^2 / sum dI^2 + s_match^2)
///
/// with alpha the inverse depth per px (Engel, Sturm, Cremers, "Semi-Dense Visual Odometry for a
/// Monocular Camera", ICCV 2013, Eq. 4 to 9), s_pose the pose's uncertainty across the edge and
/// s_I^2 the squared difference of the images: 2 s_grey^2 and what the samples say, by halves.
/// Beside it the edge's offset in the host moves the match by s_offset / cos. One observation per
/// target, the same bits with all instructions.
std::vector<Observation> search_epipolar_lines(const StereoPair& pair,
                                               const EpipolarOptions& options,
                                               std::span<const SearchTarget> targets,
                                               InstructionSet set = available_instruction_set());

}  // namespace vo
