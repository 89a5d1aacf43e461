#include "vo/core/image.h"

#include <opencv2/imgproc.hpp>

namespace vo {

GrayImage to_gray(const cv::Mat& image) {
  ByteImage luma;
  GrayImage gray;
  to_gray(image, luma, gray);
  return gray;
}

void to_gray(const cv::Mat& image, ByteImage& luma, GrayImage& gray) {
  make_writable(gray, image.size());
  if (image.channels() == 3) {
    cv::cvtColor(image, luma, cv::COLOR_BGR2GRAY);
    luma.convertTo(gray, CV_32F, 1.0 / 255);
  } else {
    image.convertTo(gray, CV_32F, 1.0 / 255);
  }
}

}  // namespace vo
