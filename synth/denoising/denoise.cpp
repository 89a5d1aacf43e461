#include "synth/denoising/denoise.h"

#include <algorithm>
#include <cstddef>

#include <opencv2/imgproc.hpp>

#include "synth/denoising/light_fit.h"

namespace synth {
namespace {

constexpr float kBrightest = 1.5F;    // of a half beside the brightest neighbour in the other
constexpr double kMostGivenBack = 1;  // relative to the light that is left
constexpr int kGivenBack = 33;        // px, edge of each square whose means spread dimmed light
constexpr int kSpreads = 3;           // of them, one after the other: nearly a Gaussian
constexpr int kBeyond = 128;          // px, more than from how far off one pixel changes another

Plane sum_of(const ColorPlanes& channels) {
  Plane sum(channels[0].size());
  for (int v = 0; v < sum.rows; ++v) {
    for (int u = 0; u < sum.cols; ++u) {
      sum(v, u) = channels[0](v, u) + channels[1](v, u) + channels[2](v, u);
    }
  }
  return sum;
}

/// Returns the factor that dims a pixel of a half if it is far brighter than all around it in the
/// other half, otherwise 1.
float dimming(const Plane& bright, const Plane& other, const cv::Point& pixel) {
  float most = 0;
  visit_around(pixel, bright.size(),
               [&](const cv::Point& near) { most = std::max(most, other(near)); });
  return bright(pixel) > kBrightest * most ? kBrightest * most / bright(pixel) : 1;
}

/// Dims what is far brighter in a half than anything around it in the other.
void dim(ColorPlanes& half, const Plane& bright, const Plane& other) {
  for (int v = 0; v < bright.rows; ++v) {
    for (int u = 0; u < bright.cols; ++u) {
      const float factor = dimming(bright, other, {u, v});
      for (Plane& channel : half) {
        channel(v, u) *= factor;
      }
    }
  }
}

/// Returns the light that arrives at the surfaces, of each half and channel.
std::array<ColorPlanes, 2> arriving_light(const NoisyPicture& picture,
                                          const ColorPlanes& reflectance) {
  std::array<ColorPlanes, 2> light{color_planes_of(picture.halves[0]),
                                   color_planes_of(picture.halves[1])};
  for (ColorPlanes& half : light) {
    for (std::size_t i = 0; i < 3; ++i) {
      cv::divide(half[i], reflectance[i], half[i]);
    }
  }
  const std::array<Plane, 2> sums{sum_of(light[0]), sum_of(light[1])};
  dim(light[0], sums[0], sums[1]);
  dim(light[1], sums[1], sums[0]);
  return light;
}

/// Returns the sum around each pixel, weighted nearly by a Gaussian of 16 px, of which a square
/// would show its edges. No two pixels differ in what they give each other, so that light is
/// conserved.
cv::Mat_<double> spread(const cv::Mat& plane) {
  cv::Mat_<double> sum;
  plane.convertTo(sum, CV_64F);
  for (int i = 0; i < kSpreads; ++i) {
    cv::boxFilter(sum, sum, CV_64F, {kGivenBack, kGivenBack}, {-1, -1}, false, cv::BORDER_CONSTANT);
  }
  return sum;
}

/// Returns the factor that gives the radiance of a channel that was dimmed back to what is around
/// it, in proportion to what is `left` there; 1 where none was. Both are sums of the halves.
Plane gain_of(const Plane& radiance, const Plane& left) {
  const cv::Mat_<double> around = spread(left);
  cv::Mat_<double> share(left.size());
  for (int v = 0; v < share.rows; ++v) {
    for (int u = 0; u < share.cols; ++u) {
      const double dimmed = std::max(0.0F, radiance(v, u) - left(v, u));
      share(v, u) = around(v, u) > 0 ? dimmed / around(v, u) : 0;
    }
  }
  share = spread(share);
  Plane gain(left.size());
  std::transform(share.begin(), share.end(), gain.begin(), [](double given) {
    return static_cast<float>(1 + std::clamp(given, 0.0, kMostGivenBack));
  });
  return gain;
}

/// Returns the nearness relative to the greatest, which is 1.
Plane relative_nearness(const Plane& nearness) {
  double greatest = 0;
  cv::minMaxLoc(nearness, nullptr, &greatest);
  return greatest > 0 ? Plane(nearness / greatest) : nearness;
}

/// Returns an image with columns from the other end beyond its left and right border.
template <typename Pixel>
cv::Mat_<Pixel> going_round(const cv::Mat_<Pixel>& image, int columns) {
  cv::Mat_<Pixel> result;
  cv::copyMakeBorder(image, result, 0, 0, columns, columns, cv::BORDER_WRAP);
  return result;
}

}  // namespace

NoisyPicture::NoisyPicture(const cv::Size& size)
    : halves{cv::Mat_<cv::Vec3f>(size), cv::Mat_<cv::Vec3f>(size)},
      shown(size),
      reflectance(size),
      normal(size),
      nearness(size) {}

cv::Mat_<cv::Vec3f> denoised(const NoisyPicture& picture) {
  LightPlanes planes;
  planes.normal = color_planes_of(picture.normal);
  planes.reflectance = color_planes_of(picture.reflectance);
  planes.nearness = relative_nearness(picture.nearness);
  const ColorPlanes divisor = divisor_of(planes.reflectance);
  planes.light = arriving_light(picture, divisor);
  for (std::size_t i = 0; i < 3; ++i) {
    planes.variance[i] = variance_of(planes.light[0][i], planes.light[1][i]);
  }
  const std::array<ColorPlanes, 2> fitted = fitted_light(planes);
  cv::Mat_<cv::Vec3f> both;
  cv::add(picture.halves[0], picture.halves[1], both);
  const ColorPlanes radiance = color_planes_of(both);
  ColorPlanes result = color_planes_of(picture.shown);
  for (std::size_t i = 0; i < 3; ++i) {
    Plane left;
    cv::add(planes.light[0][i], planes.light[1][i], left);
    cv::multiply(left, divisor[i], left);
    const Plane gain = gain_of(radiance[i], left);
    result[i] += (fitted[0][i] + fitted[1][i]).mul(divisor[i]).mul(gain) / 2;
  }
  cv::Mat_<cv::Vec3f> image;
  cv::merge(result.data(), result.size(), image);
  return image;
}

cv::Mat_<cv::Vec3f> denoised_round(const NoisyPicture& picture) {
  const cv::Size size = picture.nearness.size();
  NoisyPicture wider;
  for (std::size_t i = 0; i < 2; ++i) {
    wider.halves[i] = going_round(picture.halves[i], kBeyond);
  }
  wider.shown = going_round(picture.shown, kBeyond);
  wider.reflectance = going_round(picture.reflectance, kBeyond);
  wider.normal = going_round(picture.normal, kBeyond);
  wider.nearness = going_round(picture.nearness, kBeyond);
  return denoised(wider)(cv::Rect({kBeyond, 0}, size)).clone();
}

}  // namespace synth
