#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "tools/train_edges/labelled_views.h"
#include "vo/edges/edges.h"
#include "vo/structured_forest/structured_forest.h"

namespace tools {

/// Returns a picture with a row per view: image | exact edges | the forest's edges | Canny's. Exact
/// edges are red at depth steps, magenta at creases, blue at shadows, green at colour changes;
/// detected ones green within 2 px of an exact one, else red. `detectors` has both detectors'
/// options.
cv::Mat_<cv::Vec3b> draw_comparison(const std::vector<LabelledView>& views,
                                    const vo::StructuredForest& forest,
                                    const vo::EdgeOptions& detectors);

}  // namespace tools
