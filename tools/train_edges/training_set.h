#pragma once

#include <cstdint>
#include <vector>

#include "tools/train_edges/edge_patch.h"
#include "tools/train_edges/labelled_views.h"
#include "vo/core/random.h"
#include "vo/structured_forest/forest_features.h"

namespace tools {

/// Location of a patch: its view and the top left corner of its edge patch.
struct PatchPlace {
  std::uint32_t view = 0;
  std::uint16_t row = 0;     ///< row of the corner, px
  std::uint16_t column = 0;  ///< column of the corner, px
};

/// Features and exact edges of the patches of a set of views.
class TrainingSet {
 public:
  /// The views must outlive the set and be large enough for a patch.
  TrainingSet(const std::vector<LabelledView>& views, const vo::ForestParameters& parameters);

  /// Draws at most `per_view` random patches of each view, at most half of them with an edge in the
  /// middle and at most half without.
  std::vector<PatchPlace> draw(int per_view, vo::Random& random) const;

  float feature(const PatchPlace& place, int id) const;
  EdgePatch edges(const PatchPlace& place) const;
  int features() const { return index_.size(); }
  const vo::ForestParameters& parameters() const { return parameters_; }

 private:
  const std::vector<LabelledView>& views_;
  vo::ForestParameters parameters_;
  std::vector<vo::ForestFeatures> features_;  ///< features of each view
  vo::FeatureIndex index_;
};

}  // namespace tools
