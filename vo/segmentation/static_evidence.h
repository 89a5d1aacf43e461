#pragma once

#include <cstddef>
#include <span>

#include "vo/alignment/joint_problem.h"
#include "vo/core/inplace_vector.h"
#include "vo/image/view_grid.h"
#include "vo/segmentation/tile_mask.h"

namespace vo {

/// For each tile of a view the logarithm of how much more likely what it shows is where it is part
/// of the static world than where it moves by itself; 0 where nothing is known.
using TileEvidence = ViewTiles::Values;

/// The most that one frame's evidence counts for a tile, or against it.
inline constexpr float kMostEvidenceOfFrame = 2.5;

/// Returns the tiles that clearly move by themselves.
TileMask moving_tiles(const TileEvidence& log_odds);

/// The references that a frame is compared with.
enum class ComparedReferences {
  all,
  outer,  ///< the first and the last, which are the nearest and the farthest view
};

/// Weighs what an aligned frame and its references show of each other.
///
/// A point that is seen in the other image speaks for its tile as far as the intensity there agrees
/// with its own: a t-distribution of the images' noise stands against one of the image's contrast.
/// A point that the other image shows to be hidden says nothing. A depth that is clearly nearer
/// than what the other frame measured there speaks against its tile, because the other frame saw
/// through the place: a violation of free space, which no static scene has.
class StaticEvidence {
 public:
  /// `aligned` is what the alignment of the frame found. The references must have images.
  StaticEvidence(std::span<const AlignReference> references, const AlignCurrent& current,
                 const AlignResult& aligned, const AlignOptions& options,
                 ComparedReferences compared);

  /// Returns the evidence for the tiles of the current view.
  const TileEvidence& of_current() const { return current_; }

  /// Returns the evidence for the tiles of a reference's view, from its points in the current view.
  const TileEvidence& of_reference(std::size_t reference) const { return references_[reference]; }

 private:
  void add_intensities(const PointView& view, std::size_t pair, const ResidualModel& model);
  void add_depths(const FramePyramid& current, const FramePyramid& reference, std::size_t r,
                  const SE3& T_cur_ref);

  float weight_ = 0;  ///< of each compared reference in the current view's evidence
  TileEvidence current_{};
  InplaceVector<TileEvidence, kMaxReferences> references_;
};

}  // namespace vo
