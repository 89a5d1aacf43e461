#include "tools/train_edges/edge_score.h"

#include <opencv2/imgproc.hpp>

namespace tools {
namespace {

double share(std::size_t part, std::size_t all) {
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 1;
}

std::size_t count(const cv::Mat& mask) {
  return static_cast<std::size_t>(cv::countNonZero(mask));
}

/// Returns a mask of the pixels within the tolerance of a set pixel.
cv::Mat near_to(const cv::Mat& mask) {
  const cv::Mat is_free = mask == 0;
  if (cv::countNonZero(mask) == 0) {
    return cv::Mat(mask.size(), CV_8U, cv::Scalar(0));
  }
  cv::Mat distance;
  cv::distanceTransform(is_free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return distance <= kEdgeTolerance + 1e-3;
}

}  // namespace

EdgeScore& EdgeScore::operator+=(const EdgeScore& other) {
  detected += other.detected;
  detected_right += other.detected_right;
  labelled += other.labelled;
  labelled_found += other.labelled_found;
  for (std::size_t i = 0; i < kCauses; ++i) {
    caused[i] += other.caused[i];
    caused_found[i] += other.caused_found[i];
  }
  return *this;
}

double EdgeScore::precision() const {
  return share(detected_right, detected);
}

double EdgeScore::recall() const {
  return share(labelled_found, labelled);
}

double EdgeScore::recall_of(synth::EdgeCause cause) const {
  const auto index = static_cast<std::size_t>(cause);
  return share(caused_found[index], caused[index]);
}

double EdgeScore::f_measure() const {
  const double sum = precision() + recall();
  return sum > 0 ? 2 * precision() * recall() / sum : 0;
}

EdgeScore score_edges(const vo::EdgeMask& detected, const synth::EdgeLabels& labels) {
  const cv::Mat near_detected = near_to(detected);
  const cv::Mat is_labelled = labels != 0;
  EdgeScore score;
  score.detected = count(detected);
  score.detected_right = count(detected & near_to(is_labelled));
  score.labelled = count(is_labelled);
  score.labelled_found = count(is_labelled & near_detected);
  for (std::size_t i = 0; i < EdgeScore::kCauses; ++i) {
    const cv::Mat is_caused = (labels & bit(static_cast<synth::EdgeCause>(i))) != 0;
    score.caused[i] = count(is_caused);
    score.caused_found[i] = count(is_caused & near_detected);
  }
  return score;
}

}  // namespace tools
