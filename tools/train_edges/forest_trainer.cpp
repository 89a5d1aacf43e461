#include "tools/train_edges/forest_trainer.h"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>

#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include "vo/core/error.h"

namespace tools {
namespace {

using Tree = std::vector<TreeNode>;

void shuffle(std::vector<PatchPlace>& places, vo::Random& random) {
  for (std::size_t i = places.size(); i > 1; --i) {
    std::swap(places[i - 1], places[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
}

std::vector<LabelledView> enlarged(const std::vector<LabelledView>& views, int scale) {
  std::vector<LabelledView> result;
  for (const LabelledView& view : views) {
    const cv::Size size = view.image.size() * scale;
    LabelledView& large = result.emplace_back();
    cv::resize(view.image, large.image, size, 0, 0, cv::INTER_LINEAR);
    cv::resize(view.labels, large.labels, size, 0, 0, cv::INTER_NEAREST);
  }
  return result;
}

Tree train_tree(const TrainingSet& set, const ForestTrainingOptions& options, vo::Random random) {
  std::vector<PatchPlace> places = set.draw(options.patches_per_view, random);
  shuffle(places, random);
  return grow_tree(set, std::move(places), options.tree, random);
}

void append(const TreeNode& node, vo::ForestNodes& nodes) {
  nodes.children.push_back(node.first_child == 0 ? 0 : node.first_child + 1);
  nodes.feature_ids.push_back(node.feature);
  nodes.thresholds.push_back(node.threshold);
  for (std::size_t bin = 0; bin < node.edges.size(); ++bin) {
    if (node.edges[bin]) {
      nodes.edge_bins.push_back(static_cast<int>(bin));
    }
  }
  nodes.edge_boundaries.push_back(static_cast<int>(nodes.edge_bins.size()));
}

/// Concatenates the trees, all padded to the same number of nodes.
vo::ForestNodes joined(const std::vector<Tree>& trees) {
  std::size_t size = 0;
  for (const Tree& tree : trees) {
    size = std::max(size, tree.size());
  }
  vo::ForestNodes nodes;
  nodes.edge_boundaries.push_back(0);
  for (const Tree& tree : trees) {
    for (const TreeNode& node : tree) {
      append(node, nodes);
    }
    for (std::size_t i = tree.size(); i < size; ++i) {
      append({}, nodes);
    }
  }
  return nodes;
}

}  // namespace

void ForestTrainingOptions::validate() const {
  vo::require(trees >= 1 && trees <= 64, "trees: expected 1 to 64, got ", trees);
  vo::require(scale >= 1 && scale <= 4, "scale: expected 1 to 4, got ", scale);
  vo::require(patches_per_view >= 2, "patches_per_view: expected at least 2, got ",
              patches_per_view);
  tree.validate();
}

vo::StructuredForest train_forest(const std::vector<LabelledView>& views,
                                  const ForestTrainingOptions& options, std::uint64_t seed,
                                  const vo::Progress& progress) {
  options.validate();
  vo::ForestParameters parameters;
  parameters.trees = options.trees;
  parameters.trees_to_evaluate = (options.trees + 1) / 2;
  const std::vector<LabelledView> large = enlarged(views, options.scale);
  const TrainingSet set(large, parameters);
  std::vector<Tree> trees(static_cast<std::size_t>(options.trees));
  std::size_t done = 0;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, trees.size(), [&](std::size_t i) {
    trees[i] = train_tree(set, options, vo::Random(seed, i));
    const std::lock_guard lock(mutex);
    ++done;
    if (progress) {
      progress(done, trees.size());
    }
  });
  return {parameters, joined(trees)};
}

}  // namespace tools
