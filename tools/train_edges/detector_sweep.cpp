#include "tools/train_edges/detector_sweep.h"

#include <algorithm>
#include <cstddef>
#include <mutex>

#include <tbb/parallel_for.h>

#include "vo/core/fields.h"

namespace tools {
namespace {

DetectorCurve curve_of(vo::EdgeDetector detector, const char* name, double step, int steps) {
  DetectorCurve curve{detector, name, {}};
  for (int i = 1; i <= steps; ++i) {
    curve.points.push_back({step * i, {}});
  }
  return curve;
}

std::vector<DetectorCurve> empty_curves() {
  return {curve_of(vo::EdgeDetector::structured_forest, "forest_strength", 0.02, 30),
          curve_of(vo::EdgeDetector::canny, "percentile", 3, 33),
          curve_of(vo::EdgeDetector::canny, "strong", 10, 30),
          curve_of(vo::EdgeDetector::log, "log_strength", 0.5, 24),
          curve_of(vo::EdgeDetector::sobel, "strong", 10, 30)};
}

void add_view(const vo::StructuredForest& forest, const LabelledView& view,
              std::vector<DetectorCurve>& curves) {
  const vo::GrayImage gray = vo::to_gray(view.image);
  const cv::Mat_<float> strength =
      thin_edge_strength(forest, vo::to_rgb(view.image), vo::EdgeOptions{}.forest_scale);
  for (DetectorCurve& curve : curves) {
    for (SweepPoint& point : curve.points) {
      const cv::Mat mask = curve.detector == vo::EdgeDetector::structured_forest
                               ? cv::Mat(strength >= point.threshold)
                               : vo::detect_edges(gray, options_at(curve, point.threshold));
      point.score += score_edges(mask, view.labels);
    }
  }
}

/// Adds the scores. Sums of integer counts do not depend on the order of the views.
void add_curves(const std::vector<DetectorCurve>& from, std::vector<DetectorCurve>& to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    for (std::size_t j = 0; j < to[i].points.size(); ++j) {
      to[i].points[j].score += from[i].points[j].score;
    }
  }
}

}  // namespace

const SweepPoint& DetectorCurve::best() const {
  return *std::max_element(points.begin(), points.end(),
                           [](const SweepPoint& a, const SweepPoint& b) {
                             return a.score.f_measure() < b.score.f_measure();
                           });
}

vo::EdgeOptions options_at(const DetectorCurve& curve, double threshold) {
  constexpr double kLowFloor = 4;  // Sobel magnitude, so low that the percentile decides
  vo::EdgeOptions options;
  options.detector = curve.detector;
  options.floor = kLowFloor;
  options.threshold =
      curve.threshold_name == "strong" ? vo::EdgeThreshold::fixed : vo::EdgeThreshold::percentile;
  std::vector<vo::Field> fields = vo::fields_of(options);
  vo::set_field(fields, curve.threshold_name, vo::format_real(threshold));
  return options;
}

std::vector<DetectorCurve> sweep_detectors(const vo::StructuredForest& forest,
                                           const std::vector<LabelledView>& views,
                                           const vo::Progress& progress) {
  std::vector<DetectorCurve> curves = empty_curves();
  std::size_t done = 0;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, views.size(), [&](std::size_t i) {
    std::vector<DetectorCurve> own = empty_curves();
    add_view(forest, views[i], own);
    const std::lock_guard lock(mutex);
    add_curves(own, curves);
    ++done;
    if (progress) {
      progress(done, views.size());
    }
  });
  return curves;
}

}  // namespace tools
