#include "synth/sensor/image_noise.h"

#include <algorithm>
#include <cmath>

#include "vo/core/error.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr std::uint64_t kShot = 0x5407;
constexpr std::uint64_t kRead = 0x2ead;
constexpr std::uint64_t kGain = 0x9a17;

}  // namespace

void ImageNoiseOptions::validate() const {
  vo::require(
      full_well.allFinite() && full_well.minCoeff() >= 0 &&
          (full_well.minCoeff() > 0 || full_well.maxCoeff() == 0),
      "sensor.noise.full_well: expected three numbers above 0, or three zeros for no noise");
  vo::require(
      read_noise.allFinite() && read_noise.minCoeff() >= 0 && pixel_gain >= 0 && pixel_gain < 1,
      "sensor.noise: expected read_noise at or above 0 electrons and pixel_gain in [0, 1)");
  vo::require(is_on() || (read_noise.isZero(0) && pixel_gain == 0),
              "sensor.noise: read_noise and pixel_gain expect a full_well above 0");
}

double poisson(double mean, double uniform, double normal) {
  constexpr double kMaxInverted = 30;
  if (mean > kMaxInverted) {
    return std::max(0.0, std::round(mean + std::sqrt(mean) * normal));
  }
  double probability = std::exp(-mean);
  double below = probability;
  double count = 0;
  while (uniform >= below && probability > 0) {
    ++count;
    probability *= mean / count;
    below += probability;
  }
  return count;
}

cv::Mat_<cv::Vec3f> with_image_noise(const cv::Mat_<cv::Vec3f>& linear,
                                     const ImageNoiseOptions& options, double amplification,
                                     std::uint64_t frame) {
  const vo::RandomField capture(options.seed, kShot, frame);
  const vo::RandomField read(options.seed, kRead, frame);
  const vo::RandomField gain(options.seed, kGain, 0);  // fixed pattern: equal in all frames
  cv::Mat_<cv::Vec3f> noisy(linear.size());
  for (int v = 0; v < linear.rows; ++v) {
    for (int u = 0; u < linear.cols; ++u) {
      for (int c = 0; c < 3; ++c) {
        const double electrons_at_one = options.full_well[c] / amplification;
        const double own_gain = 1 + options.pixel_gain * gain.normal(u, v, c);
        const double mean = std::max(0.0, linear(v, u)[c] * own_gain) * electrons_at_one;
        const double electrons =
            poisson(mean, capture.uniform(u, v, c), capture.normal(u, v, 3 + c)) +
            options.read_noise[c] * read.normal(u, v, c);
        noisy(v, u)[c] = static_cast<float>(electrons / electrons_at_one);
      }
    }
  }
  return noisy;
}

}  // namespace synth
