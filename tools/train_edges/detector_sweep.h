#pragma once

#include <string>
#include <vector>

#include "tools/train_edges/edge_score.h"
#include "tools/train_edges/labelled_views.h"
#include "vo/core/progress.h"
#include "vo/edges/edges.h"
#include "vo/structured_forest/structured_forest.h"

namespace tools {

/// A detector's score at one value of the threshold that is swept.
struct SweepPoint {
  double threshold = 0;
  EdgeScore score;
};

/// A detector's scores over the range of one threshold.
struct DetectorCurve {
  vo::EdgeDetector detector = vo::EdgeDetector::canny;
  std::string threshold_name;  ///< the field of EdgeOptions that is swept
  std::vector<SweepPoint> points;

  const SweepPoint& best() const;  ///< the point with the greatest F-measure over all views
};

/// Runs the forest, Canny by percentile and by fixed thresholds, LoG and Sobel, in this order, over
/// all views at all their settings. The forest sees colour, the others grey.
std::vector<DetectorCurve> sweep_detectors(const vo::StructuredForest& forest,
                                           const std::vector<LabelledView>& views,
                                           const vo::Progress& progress);

/// Returns the options of a curve's detector at one of its thresholds.
vo::EdgeOptions options_at(const DetectorCurve& curve, double threshold);

}  // namespace tools
