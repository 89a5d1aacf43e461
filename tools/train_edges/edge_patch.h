#pragma once

#include <bitset>
#include <vector>

#include <opencv2/core.hpp>

#include "synth/truth/edge_labels.h"
#include "vo/core/random.h"

namespace tools {

/// The edge pixels of a 16x16 patch, or any other set of its pixels; bit 16 u + v is pixel (u, v).
inline constexpr int kPatchSide = 16;  // px
using EdgePatch = std::bitset<static_cast<std::size_t>(kPatchSide* kPatchSide)>;

/// The labelled pixels right of and below `corner`; the patch lies in the image.
EdgePatch edge_patch(const synth::EdgeLabels& labels, const cv::Point& corner);

/// The pixels that a straight line between two pixels' centres passes through, without gaps that
/// a line of touching corners could slip through. The ends do not belong to it.
EdgePatch line_between(const cv::Point& from, const cv::Point& to);

/// Lines between `count` random pairs of pixels. What a patch's edges say about "does an edge
/// separate these two pixels" for all of them is its place in the space in which the forest tells
/// like from unlike edges: the paper's mapping of structured labels, with lines that cross edges in
/// the place of segments, because exact edges need not close.
std::vector<EdgePatch> random_lines(int count, vo::Random& random);

}  // namespace tools
