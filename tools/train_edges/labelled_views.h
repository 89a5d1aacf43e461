#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "synth/truth/edge_labels.h"
#include "vo/core/image.h"
#include "vo/core/progress.h"
#include "vo/core/random.h"

namespace tools {

/// A rendered image with exact edge labels.
struct LabelledView {
  vo::ColorImage image;
  synth::EdgeLabels labels;
};

/// Options of the views rendered from random free, enclosed places in random directions.
struct ViewOptions {
  int views = 150;             ///< number of views per scene
  int width = 240;             ///< px
  int height = 180;            ///< px
  double min_fov_deg = 20;     ///< least horizontal field of view, deg
  double max_fov_deg = 50;     ///< greatest horizontal field of view, deg
  double exposure_stops = 1;   ///< greatest deviation from the metered exposure, stops
  double noise = 0.015;        ///< greatest standard deviation, intensity 0..1
  double blur_px = 0.8;        ///< greatest standard deviation of the lens blur, px
  double min_contrast = 0.03;  ///< least contrast at a labelled edge, intensity 0..1
  std::uint64_t seed = 1;
  synth::EdgeLabelOptions labels;

  void validate() const;  ///< throws vo::Error on an invalid option
};

template <typename Visitor>
void visit_fields(Visitor& visit, ViewOptions& options) {
  visit("views", options.views, "rendered per scene");
  visit("width", options.width, "of a view, px");
  visit("height", options.height, "of a view, px");
  visit("min_fov_deg", options.min_fov_deg, "least horizontal field of view, deg");
  visit("max_fov_deg", options.max_fov_deg, "greatest horizontal field of view, deg");
  visit("exposure_stops", options.exposure_stops, "brighter or darker at most, powers of two");
  visit("noise", options.noise, "greatest standard deviation of noise, intensity 0..1");
  visit("blur_px", options.blur_px, "greatest standard deviation of the lens' blur, px");
  visit("min_contrast", options.min_contrast, "fainter edges are not labelled, intensity 0..1");
  visit("seed", options.seed, "of all that is random");
  visit("labels", options.labels, "");
}

/// Renders the views in parallel; the result depends only on the scene and the options. Throws
/// vo::Error where the scene has no free place.
std::vector<LabelledView> render_labelled_views(const std::filesystem::path& scene,
                                                const ViewOptions& options,
                                                const vo::Progress& progress);

}  // namespace tools
