#include "tools/train_edges/tree_trainer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "tools/train_edges/label_space.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// A split of patches by the threshold of a feature.
struct Split {
  int feature = 0;
  float threshold = 0;
  double gain = 0;  ///< decrease of the Gini impurity times the number of patches
};

struct ClassifiedValue {
  float value = 0;
  bool is_second = false;
};

/// Returns `count` times the Gini impurity of patches, `second` of them of the second class.
double impurity(double count, double second) {
  return count > 0 ? 2 * second * (count - second) / count : 0;
}

/// Returns the value rounded to 1e-4, to keep the model file small.
float short_number(float value) {
  constexpr float kUnit = 1e-4F;
  return std::round(value / kUnit) * kUnit;
}

/// Replaces `best` by a split of this feature that gains more, if any; sorts the values.
void improve(Split& best, int feature, std::vector<ClassifiedValue>& values, std::size_t least) {
  std::sort(values.begin(), values.end(), [](const ClassifiedValue& a, const ClassifiedValue& b) {
    return a.value < b.value || (a.value == b.value && a.is_second < b.is_second);
  });
  const auto count = static_cast<double>(values.size());
  const auto second = static_cast<double>(
      std::count_if(values.begin(), values.end(), [](const auto& v) { return v.is_second; }));
  const double before = impurity(count, second);
  double second_below = 0;
  for (std::size_t i = 1; i + least <= values.size(); ++i) {
    second_below += values[i - 1].is_second ? 1 : 0;
    const float threshold = short_number((values[i - 1].value + values[i].value) / 2);
    if (i < least || !(values[i - 1].value < threshold && threshold <= values[i].value)) {
      continue;
    }
    const auto below = static_cast<double>(i);
    const double gain =
        before - impurity(below, second_below) - impurity(count - below, second - second_below);
    if (gain > best.gain) {
      best = {feature, threshold, gain};
    }
  }
}

/// A leaf that may still be split.
struct Leaf {
  std::size_t node = 0;
  std::span<PatchPlace> places;
  Split split;
};

class TreeGrower {
 public:
  TreeGrower(const TrainingSet& set, std::vector<PatchPlace> places, const TreeOptions& options,
             vo::Random& random)
      : set_(set), places_(std::move(places)), options_(options), random_(random) {}

  std::vector<TreeNode> grow() {
    add_leaf(places_);
    while (leaves_.size() < static_cast<std::size_t>(options_.max_leaves)) {
      const auto best = std::max_element(
          leaves_.begin(), leaves_.end(),
          [](const Leaf& a, const Leaf& b) { return a.split.gain < b.split.gain; });
      if (!(best->split.gain > 0)) {
        break;
      }
      const Leaf parent = *best;
      leaves_.erase(best);
      split(parent);
    }
    for (const Leaf& leaf : leaves_) {
      nodes_[leaf.node].edges = typical_edges(leaf.places);
    }
    return std::move(nodes_);
  }

 private:
  void add_leaf(std::span<PatchPlace> places) {
    leaves_.push_back({nodes_.size(), places, best_split(places)});
    nodes_.emplace_back();
  }

  void split(const Leaf& parent) {
    const Split& split = parent.split;
    const auto middle = std::stable_partition(
        parent.places.begin(), parent.places.end(), [&](const PatchPlace& place) {
          return set_.feature(place, split.feature) < split.threshold;
        });
    const auto below = static_cast<std::size_t>(middle - parent.places.begin());
    TreeNode& node = nodes_[parent.node];
    node.feature = split.feature;
    node.threshold = split.threshold;
    node.first_child = static_cast<int>(nodes_.size());
    add_leaf(parent.places.first(below));
    add_leaf(parent.places.subspan(below));
  }

  std::vector<EdgePatch> edges_of(std::span<const PatchPlace> places) const {
    std::vector<EdgePatch> edges;
    for (const PatchPlace& place : places) {
      edges.push_back(set_.edges(place));
    }
    return edges;
  }

  /// Returns the best split found, without gain where the patches are too few or alike. The gain
  /// for all patches is estimated from `split_samples` of them.
  Split best_split(std::span<const PatchPlace> places) {
    const auto least = static_cast<std::size_t>(options_.min_samples);
    if (places.size() < 2 * least) {
      return {};
    }
    const auto sample =
        places.first(std::min(places.size(), static_cast<std::size_t>(options_.split_samples)));
    const std::vector<EdgePatch> lines = random_lines(options_.lines, random_);
    const std::vector<bool> classes = two_classes(separations(edges_of(sample), lines));
    if (classes.empty()) {
      return {};
    }
    const std::size_t least_of_sample =
        std::max<std::size_t>(1, least * sample.size() / places.size());
    Split best;
    std::vector<ClassifiedValue> values(sample.size());
    const int candidates = static_cast<int>(std::sqrt(set_.features()));
    for (int i = 0; i < candidates; ++i) {
      const int feature = random_.below(set_.features());
      for (std::size_t j = 0; j < sample.size(); ++j) {
        values[j] = {set_.feature(sample[j], feature), classes[j]};
      }
      improve(best, feature, values, least_of_sample);
    }
    best.gain *= static_cast<double>(places.size()) / static_cast<double>(sample.size());
    return best;
  }

  /// Returns the edges of the medoid: the patch that is most like the others.
  EdgePatch typical_edges(std::span<const PatchPlace> places) {
    constexpr std::size_t kSamples = 256;
    const std::vector<EdgePatch> edges = edges_of(places.first(std::min(places.size(), kSamples)));
    return edges[medoid(separations(edges, random_lines(2 * options_.lines, random_)))];
  }

  const TrainingSet& set_;
  std::vector<PatchPlace> places_;
  const TreeOptions& options_;
  vo::Random& random_;
  std::vector<TreeNode> nodes_;
  std::vector<Leaf> leaves_;
};

}  // namespace

void TreeOptions::validate() const {
  vo::require(max_leaves >= 1 && max_leaves <= 1000000, "max_leaves: expected 1 to 1000000, got ",
              max_leaves);
  vo::require(min_samples >= 1, "min_samples: expected above 0, got ", min_samples);
  vo::require(split_samples >= 2 * min_samples,
              "split_samples: expected at least twice min_samples, got ", split_samples);
  vo::require(lines >= 1 && lines <= 10000, "lines: expected 1 to 10000, got ", lines);
}

std::vector<TreeNode> grow_tree(const TrainingSet& set, std::vector<PatchPlace> places,
                                const TreeOptions& options, vo::Random& random) {
  vo::require(!places.empty(), "training: no patches, expected at least one");
  return TreeGrower(set, std::move(places), options, random).grow();
}

}  // namespace tools
