#pragma once

#include "vo/geometry/depth_noise.h"
#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"
#include "vo/segmentation/tile_mask.h"

namespace vo {

/// The depth images of two frames, and the transform between the frames.
struct DepthPair {
  const PyramidLevel& reference;
  const PyramidLevel& current;
  SE3 T_cur_ref;
};

/// Returns by how much the depths of two frames differ beyond the sensor's noise: the median of
/// max(0, |z - z'| - sqrt(2) sigma) / z', at most 0.1, over the reference's pixels, where z' is the
/// depth that what is measured there has in the current frame, z the depth that is measured where
/// it is seen, and sigma the noise of each. What is nearer by more than a tenth hides the surface
/// and is left out, as are pixels that are seen in tiles of the current view that move. Of a large
/// image it takes some thousand pixels, evenly spread. 0 where fewer than 50 are compared.
double depth_deviation(const DepthPair& pair, const DepthNoise& noise, const TileMask& moving);

}  // namespace vo
