#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "tools/train_edges/detector_sweep.h"
#include "tools/train_edges/labelled_views.h"
#include "vo/structured_forest/structured_forest.h"

namespace tools {

/// Returns a picture with a row for every n-th view: image | exact edges | the forest's edges |
/// Canny's, each detector at its best. Exact edges are red at depth steps, magenta at creases, blue
/// at shadows, green at colour changes; detected ones green within 2 px of an exact one, else red.
/// `curves` are those of `sweep_detectors`.
cv::Mat_<cv::Vec3b> draw_comparison(const std::vector<LabelledView>& views, std::size_t every,
                                    const vo::StructuredForest& forest,
                                    const std::vector<DetectorCurve>& curves);

}  // namespace tools
