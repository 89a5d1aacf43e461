#pragma once

#include <vector>

#include "tools/train_edges/training_set.h"

namespace tools {

struct TreeOptions {
  int max_leaves = 1200;     ///< per tree; the model's size follows from it
  int min_samples = 4;       ///< patches that a leaf is made of at least
  int split_samples = 3000;  ///< patches at most that a split is chosen by
  int lines = 128;           ///< that patches are told apart by at a split

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, TreeOptions& options) {
  visit("max_leaves", options.max_leaves, "per tree; the model's size follows from it");
  visit("min_samples", options.min_samples, "patches that a leaf is made of at least");
  visit("split_samples", options.split_samples, "patches at most that a split is chosen by");
  visit("lines", options.lines, "that patches are told apart by at a split");
}

/// A node of a tree under growth; children follow their parent in pairs.
struct TreeNode {
  int first_child = 0;  ///< below the threshold; the next one is at or above. 0 = leaf
  int feature = 0;
  float threshold = 0;
  EdgePatch edges;  ///< of a leaf
};

/// Grows one tree of a structured forest, always at the leaf where a split gains most.
/// `places` in random order.
std::vector<TreeNode> grow_tree(const TrainingSet& set, std::vector<PatchPlace> places,
                                const TreeOptions& options, vo::Random& random);

}  // namespace tools
