#include "vo/tracking/sharpness.h"

#include <cmath>

#include "vo/residuals/warp.h"

namespace vo {
namespace {

/// Sums of gradient magnitudes and of intensities over pixels of one image.
struct Strength {
  double gradient = 0;
  double intensity = 0;

  void add(const GrayImage& image, cv::Point pixel) {
    gradient += cv::norm(central_gradient(image, pixel));
    intensity += image(pixel);
  }

  double contrast() const { return intensity > 0 ? gradient / intensity : 0; }
};

/// Returns the contrast of `other` over that of `image`, at those of the image's points that both
/// see, or 0 if there are none.
double contrast_ratio(const PointedImage& image, const PointedImage& other,
                      const SE3& T_other_image) {
  const Warp<float> warp(other.level.camera, T_other_image);
  Strength own;
  Strength others;
  for (std::size_t i = 0; i < image.points.size(); ++i) {
    const WarpedPoint<float> point = warp_point<float>(
        warp, {image.points.x_ref[i], image.points.y_ref[i], image.points.z_ref[i]});
    if (is_in_view(point, other.level.camera)) {
      own.add(image.level.intensity, image.points.pixel[i]);
      others.add(other.level.intensity, {cvRound(point.u), cvRound(point.v)});
    }
  }
  return own.contrast() > 0 ? others.contrast() / own.contrast() : 0;
}

}  // namespace

double relative_sharpness(const PointedImage& reference, const PointedImage& current,
                          const SE3& T_cur_ref) {
  const double at_reference = contrast_ratio(reference, current, T_cur_ref);
  const double at_current = contrast_ratio(current, reference, T_cur_ref.inverse());
  return at_reference > 0 && at_current > 0 ? std::sqrt(at_reference / at_current) : 1;
}

}  // namespace vo
