#pragma once

#include <cstddef>

#include "synth/truth/edge_labels.h"
#include "vo/core/image.h"
#include "vo/dataset/sequence.h"

namespace tools {

/// Ground truth of one view, or what a depth sensor measured of it.
struct TrueView {
  vo::DepthImage depth;
  synth::EdgeLabels causes;  ///< causes of the view's edges; empty where unknown
  double depth_noise = 0;    ///< standard deviation of the inverse depth, 1/m; 0 where it is exact
};

/// Returns the renderer's exact edges of a frame, from the channel `edges` (`edvo render --channels
/// edges`); empty where the sequence has none. Throws vo::Error if the labels have another size.
synth::EdgeLabels true_edges(const vo::SequenceReader& sequence, std::size_t frame);

}  // namespace tools
