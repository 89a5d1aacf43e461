#pragma once

#include <opencv2/core.hpp>

namespace vo {

using ColorImage = cv::Mat_<cv::Vec3b>;     ///< sRGB, BGR order as OpenCV stores it
using ByteImage = cv::Mat_<uchar>;          ///< sRGB-encoded grey, 0..255
using GrayImage = cv::Mat_<float>;          ///< sRGB-encoded grey, 0..1
using DepthImage = cv::Mat_<float>;         ///< metres along the optical axis; 0 = no measurement
using GradientImage = cv::Mat_<cv::Vec2f>;  ///< (dI/du, dI/dv), intensity per px
using RayImage = cv::Mat_<cv::Vec2f>;       ///< (X / Z, Y / Z) of each pixel's viewing ray
using EdgeMask = cv::Mat_<uchar>;           ///< 0 or 255

inline bool has_depth(float depth) {
  return depth > 0;
}

/// One RGB-D measurement. Images share storage like any cv::Mat and are never written again.
struct RgbdFrame {
  double timestamp = 0;    ///< s, stamp of the colour image
  cv::Mat image;           ///< ColorImage or ByteImage
  DepthImage depth;        ///< registered to the image
  double depth_delay = 0;  ///< s, from the stamp of the image to that of the depth
};

/// Gives an image this size and pixels that may be written: its own if no other image shares them.
template <typename Pixel>
void make_writable(cv::Mat_<Pixel>& image, cv::Size size) {
  if (image.u == nullptr || image.u->refcount != 1) {
    image.release();
  }
  image.create(size);
}

/// Returns the luma (ITU-R BT.601) of a ColorImage, or the grey of a ByteImage, scaled to 0..1.
GrayImage to_gray(const cv::Mat& image);

/// Writes the grey image, 0..1, to `gray`, reusing its memory if no other image shares it; `luma`
/// is working memory for a ColorImage.
void to_gray(const cv::Mat& image, ByteImage& luma, GrayImage& gray);

}  // namespace vo
