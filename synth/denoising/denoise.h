#pragma once

#include <array>

#include <opencv2/core.hpp>

namespace synth {

/// A rendered picture before its noise is removed: means over the samples of each pixel, all images
/// of one size. Reflectance, normal and nearness are 0 for samples that meet no surface; they are
/// means over the same samples as the radiance, so that edges and motion mix them as they mix it.
struct NoisyPicture {
  NoisyPicture() = default;
  explicit NoisyPicture(const cv::Size& size);

  std::array<cv::Mat_<cv::Vec3f>, 2> halves;  ///< linear RGB, noisy radiance, of two independent
                                              ///< halves of the samples
  cv::Mat_<cv::Vec3f> shown;        ///< linear RGB, radiance without noise, which comes on top
  cv::Mat_<cv::Vec3f> reflectance;  ///< linear RGB, share of the light that is sent back
  cv::Mat_<cv::Vec3f> normal;       ///< any fixed axes, of length 1 before the mean
  cv::Mat_<float> nearness;         ///< 1/m, inverse depth
};

/// Returns the linear RGB radiance without most of its noise. The light that arrives, radiance over
/// reflectance, is fitted around each pixel as a linear function of normal, nearness and place
/// (first-order regression: Bitterli et al., Nonlinearly weighted first-order regression for
/// denoising Monte Carlo renderings, 2016). A pixel counts for as much as its normal, nearness and
/// reflectance are alike, and its light as the other half of the samples sees it, given the noise
/// that the difference of the halves tells. What is far brighter in a half than all around it in
/// the other is dimmed, and given back to the pixels within 48 px, nearly by a Gaussian of 16 px
/// and in proportion to their light, which becomes at most twice as much.
cv::Mat_<cv::Vec3f> denoised(const NoisyPicture& picture);

/// Does the same of a picture that goes round, whose last column is beside its first.
cv::Mat_<cv::Vec3f> denoised_round(const NoisyPicture& picture);

}  // namespace synth
