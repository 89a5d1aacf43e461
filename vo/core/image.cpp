#include "vo/core/image.h"

#include <opencv2/imgproc.hpp>

namespace vo {

GrayImage to_gray(const cv::Mat& image) {
  cv::Mat gray = image;
  if (image.channels() == 3) {
    cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  }
  GrayImage scaled;
  gray.convertTo(scaled, CV_32F, 1.0 / 255);
  return scaled;
}

}  // namespace vo
