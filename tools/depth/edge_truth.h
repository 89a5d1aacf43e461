#pragma once

#include <cstddef>

#include "synth/truth/edge_labels.h"
#include "vo/core/image.h"
#include "vo/dataset/sequence.h"

namespace tools {

/// What is true of one view.
struct TrueView {
  vo::DepthImage depth;
  synth::EdgeLabels causes;  ///< of its edges; empty where nobody knows
};

/// The renderer's exact edges of a frame, from the channel `edges` (`edvo render --channels
/// edges`); empty where the sequence has none.
synth::EdgeLabels true_edges(const vo::SequenceReader& sequence, std::size_t frame);

}  // namespace tools
