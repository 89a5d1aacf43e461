#pragma once

#include <cstdint>
#include <vector>

#include "tools/train_edges/tree_trainer.h"
#include "vo/core/progress.h"
#include "vo/structured_forest/structured_forest.h"

namespace tools {

struct ForestTrainingOptions {
  int trees = 8;
  int scale = 2;  ///< factor by which views are enlarged, as `forest_scale` does at detection
  int patches_per_view = 600;  ///< patches per view that each tree learns from
  TreeOptions tree;

  void validate() const;  ///< throws vo::Error on an invalid option
};

template <typename Visitor>
void visit_fields(Visitor& visit, ForestTrainingOptions& options) {
  visit("trees", options.trees, "in the forest; half of them are asked about each patch");
  visit("scale", options.scale, "views are enlarged by it, as edges.forest_scale will do");
  visit("patches_per_view", options.patches_per_view, "that each tree learns from");
  visit("tree", options.tree, "");
}

/// Learns a structured forest (Dollar & Zitnick, ICCV 2013) from views with exact edges, trees in
/// parallel; the result depends only on the arguments.
vo::StructuredForest train_forest(const std::vector<LabelledView>& views,
                                  const ForestTrainingOptions& options, std::uint64_t seed,
                                  const vo::Progress& progress);

}  // namespace tools
