#pragma once

#include <cstddef>

#include "synth/truth/edge_labels.h"
#include "vo/core/image.h"
#include "vo/dataset/sequence.h"

namespace tools {

/// Ground truth of one view.
struct TrueView {
  vo::DepthImage depth;
  synth::EdgeLabels causes;  ///< causes of the view's edges; empty where unknown
};

/// Returns the renderer's exact edges of a frame, from the channel `edges` (`edvo render --channels
/// edges`); empty where the sequence has none. Throws vo::Error if the labels have another size.
synth::EdgeLabels true_edges(const vo::SequenceReader& sequence, std::size_t frame);

}  // namespace tools
