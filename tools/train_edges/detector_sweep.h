#pragma once

#include <string>
#include <vector>

#include "tools/train_edges/edge_score.h"
#include "tools/train_edges/labelled_views.h"
#include "vo/core/progress.h"
#include "vo/edges/edges.h"
#include "vo/structured_forest/structured_forest.h"

namespace tools {

/// What a detector gives at one setting of the one threshold that is swept.
struct SweepPoint {
  double threshold = 0;
  EdgeScore score;
};

/// A detector over the range of one threshold.
struct DetectorCurve {
  vo::EdgeDetector detector = vo::EdgeDetector::canny;
  std::string threshold_name;  ///< the field of EdgeOptions that is swept
  std::vector<SweepPoint> points;

  const SweepPoint& best() const;  ///< of the greatest F-measure over all views
};

/// Runs the forest, Canny by percentile and by fixed thresholds, LoG and Sobel over all views at
/// all their settings, in this order. The forest sees colour, all else grey.
std::vector<DetectorCurve> sweep_detectors(const vo::StructuredForest& forest,
                                           const std::vector<LabelledView>& views,
                                           const vo::Progress& progress);

/// Options of a curve's detector at one of its thresholds.
vo::EdgeOptions options_at(const DetectorCurve& curve, double threshold);

}  // namespace tools
