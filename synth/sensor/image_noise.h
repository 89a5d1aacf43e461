#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace synth {

/// Noise of the image sensor after EMVA 1288: photons arrive by chance, each pixel turns them into
/// electrons with a gain of its own, and reading adds noise.
struct ImageNoiseOptions {
  Eigen::Vector3d full_well = Eigen::Vector3d::Zero();   ///< electrons at 1.0, of red, green, blue
  Eigen::Vector3d read_noise = Eigen::Vector3d::Zero();  ///< electrons, standard deviation
  double pixel_gain = 0;  ///< standard deviation of the pixels' gains, share (PRNU)
  std::uint64_t seed = 0;

  bool is_on() const { return full_well.minCoeff() > 0; }
  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, ImageNoiseOptions& options) {
  visit("full_well", options.full_well, "electrons at 1.0 in red, green, blue; 0 = no noise");
  visit("read_noise", options.read_noise, "standard deviation in red, green, blue, electrons");
  visit("pixel_gain", options.pixel_gain, "standard deviation of the pixels' gains, share (PRNU)");
  visit("seed", options.seed, "of this noise");
}

/// How many events happen where `mean` are expected: by inversion of a uniform number, above 30 by
/// a normal one with the same mean and variance.
double poisson(double mean, double uniform, double normal);

/// What an image in linear 0..1 becomes when it is counted in electrons. Amplified n times, 1.0 is
/// reached with one nth of them. Not clipped.
cv::Mat_<cv::Vec3f> with_image_noise(const cv::Mat_<cv::Vec3f>& linear,
                                     const ImageNoiseOptions& options, double amplification,
                                     std::uint64_t frame);

}  // namespace synth
