#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

namespace vo {

/// Parameters of a structured forest and of its features. The defaults are those of Dollar &
/// Zitnick, "Structured Forests for Fast Edge Detection", ICCV 2013.
struct ForestParameters {
  int stride = 2;                  ///< px, from patch to patch
  int shrink = 2;                  ///< px per feature pixel
  int patch_size = 32;             ///< px, side of the patch whose features are used
  int inner_size = 16;             ///< px, side of the patch whose edges are predicted
  int orientations = 4;            ///< gradient orientations per scale
  int gradient_smoothing = 0;      ///< px, of the image before gradients are taken
  int regular_smoothing = 2;       ///< px, of the features that are looked up
  int similarity_smoothing = 8;    ///< px, of the features that are compared
  int gradient_normalization = 4;  ///< px, radius over which gradients are normalised
  int grid_size = 5;               ///< cells along the patch that are compared with each other
  int trees = 8;
  int trees_to_evaluate = 4;  ///< trees that each patch is passed to

  /// Returns the number of channels: Luv, and gradient magnitude and orientations at two scales.
  int channels() const { return 3 + 2 * (1 + orientations); }
  int padding() const { return (patch_size - inner_size) / 2; }  ///< px
  int bins() const { return inner_size * inner_size; }           ///< pixels of a predicted patch

  void validate() const;  ///< throws Error unless the values are usable
};

/// The feature channels of one padded image, `shrink` times smaller.
struct ForestFeatures {
  cv::Mat regular;     ///< float, `channels()`
  cv::Mat similarity;  ///< float, `channels()`, smoothed more than `regular`
};

/// Computes the features of an image, `rgb` in 0..1, padded by reflection so that a patch lies
/// around every pixel.
ForestFeatures forest_features(const cv::Mat_<cv::Vec3f>& rgb, const ForestParameters& parameters);

/// Returns the columns and rows of the patches whose predicted edges lie in the image, `stride` px
/// apart from its top left corner.
cv::Size patch_grid(const cv::Size& image, const ForestParameters& parameters);

/// Numbers the features of a patch as the model format does: first each pixel of each regular
/// channel, column by column; then, for each similarity channel, the differences of all pairs of
/// grid cells.
class FeatureIndex {
 public:
  /// `step` is the length of a feature row, floats.
  FeatureIndex(const ForestParameters& parameters, std::size_t step);

  int size() const { return static_cast<int>(regular_.size() + pairs_.size()); }

  /// Returns the value of feature `id`; both pointers are to the patch's first feature pixel.
  float value(int id, const float* regular, const float* similarity) const {
    const auto index = static_cast<std::size_t>(id);
    if (index < regular_.size()) {
      return regular[regular_[index]];
    }
    const Pair& pair = pairs_[index - regular_.size()];
    return similarity[pair.first] - similarity[pair.second];
  }

 private:
  struct Pair {
    std::size_t first;
    std::size_t second;
  };

  std::vector<std::size_t> regular_;  ///< offset of each feature from the patch's first, floats
  std::vector<Pair> pairs_;
};

/// Returns the number of features of a patch.
int feature_count(const ForestParameters& parameters);

}  // namespace vo
