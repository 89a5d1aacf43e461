#pragma once

#include <vector>

#include "tools/train_edges/training_set.h"

namespace tools {

struct TreeOptions {
  int max_leaves = 1200;     ///< greatest number of leaves per tree; determines the model's size
  int min_samples = 4;       ///< least number of patches in a leaf
  int split_samples = 3000;  ///< greatest number of patches that a split is chosen from
  int lines = 128;           ///< random lines that classify the patches at a split

  void validate() const;  ///< throws vo::Error on an invalid option
};

template <typename Visitor>
void visit_fields(Visitor& visit, TreeOptions& options) {
  visit("max_leaves", options.max_leaves, "per tree; the model's size follows from it");
  visit("min_samples", options.min_samples, "patches that a leaf is made of at least");
  visit("split_samples", options.split_samples, "patches at most that a split is chosen by");
  visit("lines", options.lines, "that patches are told apart by at a split");
}

/// A node of a tree under construction; children are stored in pairs after their parent.
struct TreeNode {
  int first_child = 0;  ///< index of the child below the threshold; the other one follows. 0 = leaf
  int feature = 0;
  float threshold = 0;
  EdgePatch edges;  ///< typical edges of a leaf
};

/// Grows one tree of a structured forest, always at the leaf whose split gains most. `places` must
/// be in random order.
std::vector<TreeNode> grow_tree(const TrainingSet& set, std::vector<PatchPlace> places,
                                const TreeOptions& options, vo::Random& random);

}  // namespace tools
