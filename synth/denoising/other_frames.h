#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "synth/denoising/denoise.h"

namespace synth {

/// The picture of another frame of a sequence, and where the surface points of a frame's pixels are
/// in it.
struct OtherFrame {
  const NoisyPicture* picture;
  cv::Mat_<cv::Vec2f> places;  ///< px, pixel centres at integers; not a number if not in its view
  /// Nearness of each point, in the other frame's view over in the frame's own, which tells whether
  /// another surface hides it.
  cv::Mat_<float> nearness_ratio;
  bool wraps = false;  ///< whether its first column is beside its last
};

/// Returns a frame's picture with the light of other frames. The light that arrives at a pixel's
/// point, radiance over reflectance, becomes a mean of what the frames tell of it. Another frame
/// counts where it shows the point, and for as much as its light there is alike in patches of 5 x 5
/// px given the noise that the difference of the halves tells: each half's is compared by the
/// other, so that the halves stay independent.
NoisyPicture with_light_of(const NoisyPicture& picture, const std::vector<OtherFrame>& others);

}  // namespace synth
