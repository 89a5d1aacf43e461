#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace synth {

/// Noise of the image sensor after EMVA 1288: photon shot noise, a gain that differs from pixel to
/// pixel, and read noise.
struct ImageNoiseOptions {
  Eigen::Vector3d full_well = Eigen::Vector3d::Zero();   ///< electrons at linear 1.0, RGB; 0 = off
  Eigen::Vector3d read_noise = Eigen::Vector3d::Zero();  ///< electrons, standard deviation, RGB
  double pixel_gain = 0;  ///< standard deviation of the pixels' gains, share (PRNU)
  std::uint64_t seed = 0;

  bool is_on() const { return full_well.minCoeff() > 0; }
  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, ImageNoiseOptions& options) {
  visit("full_well", options.full_well, "electrons at 1.0 in red, green, blue; 0 = no noise");
  visit("read_noise", options.read_noise, "standard deviation in red, green, blue, electrons");
  visit("pixel_gain", options.pixel_gain, "standard deviation of the pixels' gains, share (PRNU)");
  visit("seed", options.seed, "of this noise");
}

/// Returns a Poisson-distributed number of mean `mean`: by inversion of `uniform`, in [0, 1), and
/// above a mean of 30 from the standard normal number `normal`.
double poisson(double mean, double uniform, double normal);

/// Returns a linear image, 0..1, with shot noise, pixel gains and read noise. Amplified n times,
/// 1.0 is reached with one n-th of the full well's electrons. The result is not clipped.
cv::Mat_<cv::Vec3f> with_image_noise(const cv::Mat_<cv::Vec3f>& linear,
                                     const ImageNoiseOptions& options, double amplification,
                                     std::uint64_t frame);

}  // namespace synth
