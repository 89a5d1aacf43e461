#pragma once

#include <cstdint>
#include <vector>

#include "tools/train_edges/edge_patch.h"
#include "tools/train_edges/labelled_views.h"
#include "vo/core/random.h"
#include "vo/structured_forest/forest_features.h"

namespace tools {

/// Where a patch lies.
struct PatchPlace {
  std::uint32_t view = 0;
  std::uint16_t row = 0;     ///< px, of its edges' top left corner
  std::uint16_t column = 0;  ///< px
};

/// Features and exact edges of the patches of some views.
class TrainingSet {
 public:
  /// The views must outlive the set and be large enough for a patch.
  TrainingSet(const std::vector<LabelledView>& views, const vo::ForestParameters& parameters);

  /// `per_view` of each view, half of them (where there are as many) with an edge in the middle.
  std::vector<PatchPlace> draw(int per_view, vo::Random& random) const;

  float feature(const PatchPlace& place, int id) const;
  EdgePatch edges(const PatchPlace& place) const;
  int features() const { return index_.size(); }
  const vo::ForestParameters& parameters() const { return parameters_; }

 private:
  const std::vector<LabelledView>& views_;
  vo::ForestParameters parameters_;
  std::vector<vo::ForestFeatures> features_;  ///< of each view
  vo::FeatureIndex index_;
};

}  // namespace tools
