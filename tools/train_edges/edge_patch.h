#pragma once

#include <bitset>
#include <vector>

#include <opencv2/core.hpp>

#include "synth/truth/edge_labels.h"
#include "vo/core/random.h"

namespace tools {

/// A set of pixels of a 16x16 patch, such as its edge pixels; bit 16 u + v is pixel (u, v).
inline constexpr int kPatchSide = 16;  // px
using EdgePatch = std::bitset<static_cast<std::size_t>(kPatchSide* kPatchSide)>;

/// Returns the labelled pixels of the patch with this top-left corner; it must lie in the image.
EdgePatch edge_patch(const synth::EdgeLabels& labels, const cv::Point& corner);

/// Returns the 4-connected pixels that a straight line between two pixels' centres passes through,
/// without its end points, so that no diagonal edge can pass through it unseen.
EdgePatch line_between(const cv::Point& from, const cv::Point& to);

/// Returns lines between `count` random pairs of pixels. For each line, whether an edge of the
/// patch crosses it is a coordinate of the space in which the forest tells like from unlike edges:
/// the paper's mapping of structured labels, with crossed lines in the place of segments, because
/// exact edges need not be closed.
std::vector<EdgePatch> random_lines(int count, vo::Random& random);

}  // namespace tools
