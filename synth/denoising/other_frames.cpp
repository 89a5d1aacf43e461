#include "synth/denoising/other_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <opencv2/imgproc.hpp>

#include "synth/denoising/likeness.h"
#include "synth/denoising/planes.h"

namespace synth {
namespace {

constexpr float kSameNearness = 0.03F;  // greatest relative difference of one surface
constexpr float kSameNormal = 0.2F;     // greatest length of the difference
constexpr float kLeastSeen = 0.5F;      // of the weights of the pixels around a place

/// The light that arrives at surfaces, linear RGB, of each half of the samples.
using Light = std::array<cv::Mat_<cv::Vec3f>, 2>;

Light light_of(const NoisyPicture& picture, const ColorPlanes& divisor) {
  cv::Mat_<cv::Vec3f> merged;
  cv::merge(divisor.data(), divisor.size(), merged);
  Light light;
  for (std::size_t half = 0; half < 2; ++half) {
    cv::divide(picture.halves[half], merged, light[half]);
  }
  return light;
}

/// What another frame tells of the points of a frame's pixels.
struct Told {
  Light light;
  Plane seen;  ///< 1 where it shows the point, otherwise 0, and the light is the frame's own
};

/// One of the pixels around a place in another frame, and its weight in bilinear interpolation.
struct Corner {
  cv::Point pixel;
  float weight;
};

/// Returns the pixels around a place. Those outside of the image weigh nothing.
std::array<Corner, 4> corners_around(const cv::Vec2f& place, const OtherFrame& other) {
  const cv::Size size = other.picture->nearness.size();
  const int left = cvFloor(place[0]);
  const int top = cvFloor(place[1]);
  const float right_share = place[0] - static_cast<float>(left);
  const float lower_share = place[1] - static_cast<float>(top);
  std::array<Corner, 4> corners{};
  for (int i = 0; i < 4; ++i) {
    cv::Point pixel(left + i % 2, top + i / 2);
    if (other.wraps) {
      pixel.x = (pixel.x + size.width) % size.width;
    }
    const float weight =
        (i % 2 == 1 ? right_share : 1 - right_share) * (i / 2 == 1 ? lower_share : 1 - lower_share);
    const bool is_inside = cv::Rect({}, size).contains(pixel);
    corners[static_cast<std::size_t>(i)] = {is_inside ? pixel : cv::Point(),
                                            is_inside ? weight : 0};
  }
  return corners;
}

/// Returns whether a pixel of another frame shows the surface of a frame's pixel.
bool shows_surface(const NoisyPicture& picture, const cv::Point& pixel, const OtherFrame& other,
                   const cv::Point& there) {
  const float expected = picture.nearness(pixel) * other.nearness_ratio(pixel);
  const float apart = std::abs(other.picture->nearness(there) - expected);
  const cv::Vec3f turned = other.picture->normal(there) - picture.normal(pixel);
  return apart <= kSameNearness * expected && turned.dot(turned) <= kSameNormal * kSameNormal;
}

/// Sets what another frame tells of a pixel's point, if it shows it.
void tell(const NoisyPicture& picture, const OtherFrame& other, const Light& light,
          const cv::Point& pixel, Told& told) {
  const cv::Vec2f& place = other.places(pixel);
  if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || picture.nearness(pixel) <= 0) {
    return;
  }
  std::array<cv::Vec3f, 2> sums{};
  float total = 0;
  for (const Corner& corner : corners_around(place, other)) {
    if (corner.weight > 0 && shows_surface(picture, pixel, other, corner.pixel)) {
      total += corner.weight;
      sums[0] += corner.weight * light[0](corner.pixel);
      sums[1] += corner.weight * light[1](corner.pixel);
    }
  }
  if (total >= kLeastSeen) {
    told.seen(pixel) = 1;
    told.light[0](pixel) = sums[0] / total;
    told.light[1](pixel) = sums[1] / total;
  }
}

Told told_by(const NoisyPicture& picture, const Light& own, const OtherFrame& other) {
  const Light light =
      light_of(*other.picture, divisor_of(color_planes_of(other.picture->reflectance)));
  Told told{{own[0].clone(), own[1].clone()}, Plane(own[0].size(), 0.0F)};
  for (int v = 0; v < told.seen.rows; ++v) {
    for (int u = 0; u < told.seen.cols; ++u) {
      tell(picture, other, light, {u, v}, told);
    }
  }
  return told;
}

/// The planes of each half's light, and the variances of both.
struct NoisyLight {
  std::array<ColorPlanes, 2> light;  ///< of each half
  ColorPlanes variance;
};

NoisyLight noisy_light(const Light& light) {
  NoisyLight noisy{{color_planes_of(light[0]), color_planes_of(light[1])}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    noisy.variance[i] = variance_of(noisy.light[0][i], noisy.light[1][i]);
  }
  return noisy;
}

/// Returns the sum over the patch around each pixel.
cv::Mat_<double> patch_sum(const Plane& plane) {
  cv::Mat_<double> sum;
  plane.convertTo(sum, CV_64F);
  cv::boxFilter(sum, sum, CV_64F, {2 * kPatch + 1, 2 * kPatch + 1}, {-1, -1}, false,
                cv::BORDER_CONSTANT);
  return sum;
}

/// Returns how much more than by its noise the light of a half differs where another frame shows
/// the point, the mean of the channels; 0 elsewhere.
Plane difference_of(std::size_t half, const NoisyLight& here, const NoisyLight& there,
                    const Plane& seen) {
  Plane difference(seen.size(), 0.0F);
  for (int v = 0; v < seen.rows; ++v) {
    for (int u = 0; u < seen.cols; ++u) {
      for (std::size_t i = 0; seen(v, u) > 0 && i < 3; ++i) {
        difference(v, u) +=
            difference_beyond_noise({here.light[half][i](v, u), here.variance[i](v, u)},
                                    {there.light[half][i](v, u), there.variance[i](v, u)}) /
            3;
      }
    }
  }
  return difference;
}

/// Returns how much what another frame tells counts at each pixel, 0 to 1, by the light of a half.
Plane weights_by(std::size_t half, const NoisyLight& here, const NoisyLight& there,
                 const Plane& seen) {
  const cv::Mat_<double> difference = patch_sum(difference_of(half, here, there, seen));
  const cv::Mat_<double> count = patch_sum(seen);
  Plane weights(seen.size(), 0.0F);
  for (int v = 0; v < seen.rows; ++v) {
    for (int u = 0; u < seen.cols; ++u) {
      if (seen(v, u) > 0) {
        weights(v, u) = falling(std::max(0.0F, static_cast<float>(difference(v, u) / count(v, u))));
      }
    }
  }
  return weights;
}

/// Adds light by its weights to a sum and to the sum of the weights.
void add_weighted(const cv::Mat_<cv::Vec3f>& light, const Plane& weights, cv::Mat_<cv::Vec3f>& sum,
                  Plane& total) {
  for (int v = 0; v < sum.rows; ++v) {
    for (int u = 0; u < sum.cols; ++u) {
      sum(v, u) += weights(v, u) * light(v, u);
      total(v, u) += weights(v, u);
    }
  }
}

}  // namespace

NoisyPicture with_light_of(const NoisyPicture& picture, const std::vector<OtherFrame>& others) {
  const ColorPlanes divisor = divisor_of(color_planes_of(picture.reflectance));
  const Light own = light_of(picture, divisor);
  const NoisyLight here = noisy_light(own);
  Light sums{own[0].clone(), own[1].clone()};
  std::array<Plane, 2> totals{Plane(own[0].size(), 1.0F), Plane(own[0].size(), 1.0F)};
  for (const OtherFrame& other : others) {
    const Told told = told_by(picture, own, other);
    const NoisyLight there = noisy_light(told.light);
    for (std::size_t half = 0; half < 2; ++half) {
      add_weighted(told.light[half], weights_by(1 - half, here, there, told.seen), sums[half],
                   totals[half]);
    }
  }
  NoisyPicture result = picture;
  for (std::size_t half = 0; half < 2; ++half) {
    ColorPlanes radiance = color_planes_of(sums[half]);
    for (std::size_t i = 0; i < 3; ++i) {
      radiance[i] = radiance[i].mul(divisor[i]) / totals[half];
    }
    result.halves[half] = cv::Mat_<cv::Vec3f>();  // not the picture's, which it shares until here
    cv::merge(radiance.data(), radiance.size(), result.halves[half]);
  }
  return result;
}

}  // namespace synth
