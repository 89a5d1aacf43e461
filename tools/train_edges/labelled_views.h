#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "synth/truth/edge_labels.h"
#include "vo/core/image.h"
#include "vo/core/progress.h"
#include "vo/core/random.h"

namespace tools {

/// What a camera sees and where the edges truly are.
struct LabelledView {
  vo::ColorImage image;
  synth::EdgeLabels labels;
};

/// Views of a scene from random places that are free and enclosed, in random directions.
struct ViewOptions {
  int views = 150;             ///< per scene
  int width = 240;             ///< px
  int height = 180;            ///< px
  double min_fov_deg = 20;     ///< horizontal
  double max_fov_deg = 50;     ///< horizontal
  double exposure_stops = 1;   ///< brighter or darker than metered at most, powers of two
  double noise = 0.015;        ///< standard deviation at most, of intensities 0..1
  double blur_px = 0.8;        ///< standard deviation of the lens at most
  double min_contrast = 0.03;  ///< of a labelled edge in the image without noise, intensity 0..1
  std::uint64_t seed = 1;
  synth::EdgeLabelOptions labels;

  void validate() const;  ///< throws vo::Error
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

/// Renders the views, in parallel; the result depends on the scene and the options alone. Throws
/// vo::Error where the scene has no free place.
std::vector<LabelledView> render_labelled_views(const std::filesystem::path& scene,
                                                const ViewOptions& options,
                                                const vo::Progress& progress);

}  // namespace tools
