#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "tools/train_edges/labelled_views.h"
#include "vo/edges/edges.h"
#include "vo/structured_forest/structured_forest.h"

namespace tools {

/// A row per view: image | exact edges | the forest's edges | Canny's. Exact edges are red where
/// depth steps, magenta at creases, green where colour changes, blue at shadows; detected ones
/// green within 2 px of an exact one, else red. `detectors` has Canny's options and the forest's.
cv::Mat_<cv::Vec3b> draw_comparison(const std::vector<LabelledView>& views,
                                    const vo::StructuredForest& forest,
                                    const vo::EdgeOptions& detectors);

}  // namespace tools
