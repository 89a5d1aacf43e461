#include "tools/train_edges/training_set.h"

#include <cstddef>

#include "vo/core/error.h"
#include "vo/structured_forest/structured_forest.h"

namespace tools {
namespace {

std::vector<vo::ForestFeatures> features_of(const std::vector<LabelledView>& views,
                                            const vo::ForestParameters& parameters) {
  vo::require(!views.empty(), "training: expected at least one view");
  std::vector<vo::ForestFeatures> features;
  for (const LabelledView& view : views) {
    vo::require(view.image.size() == views.front().image.size(),
                "training: expected all views of one size");
    features.push_back(vo::forest_features(vo::to_rgb(view.image), parameters));
  }
  return features;
}

/// Returns whether an edge runs through the middle 4x4 px.
bool has_edge_in_middle(const synth::EdgeLabels& labels, const PatchPlace& place) {
  constexpr int kMiddle = 4;  // px
  constexpr int kMargin = (kPatchSide - kMiddle) / 2;
  return cv::countNonZero(
             labels(cv::Rect(place.column + kMargin, place.row + kMargin, kMiddle, kMiddle))) > 0;
}

}  // namespace

TrainingSet::TrainingSet(const std::vector<LabelledView>& views,
                         const vo::ForestParameters& parameters)
    : views_(views),
      parameters_(parameters),
      features_(features_of(views, parameters)),
      index_(parameters, features_.front().regular.step1()) {}

std::vector<PatchPlace> TrainingSet::draw(int per_view, vo::Random& random) const {
  const cv::Size size = views_.front().image.size();
  const cv::Size grid = vo::patch_grid(size, parameters_);
  const int tries = 4 * per_view;
  std::vector<PatchPlace> places;
  for (std::uint32_t view = 0; view < views_.size(); ++view) {
    int with_edge = 0;
    int without_edge = 0;
    for (int i = 0; i < tries; ++i) {
      const PatchPlace place{
          view, static_cast<std::uint16_t>(random.below(grid.height) * parameters_.stride),
          static_cast<std::uint16_t>(random.below(grid.width) * parameters_.stride)};
      int& count = has_edge_in_middle(views_[view].labels, place) ? with_edge : without_edge;
      if (count < per_view / 2) {
        ++count;
        places.push_back(place);
      }
    }
  }
  return places;
}

float TrainingSet::feature(const PatchPlace& place, int id) const {
  const vo::ForestFeatures& features = features_[place.view];
  const int row = place.row / parameters_.shrink;
  const int offset = place.column / parameters_.shrink * parameters_.channels();
  return index_.value(id, features.regular.ptr<float>(row) + offset,
                      features.similarity.ptr<float>(row) + offset);
}

EdgePatch TrainingSet::edges(const PatchPlace& place) const {
  return edge_patch(views_[place.view].labels, {place.column, place.row});
}

}  // namespace tools
