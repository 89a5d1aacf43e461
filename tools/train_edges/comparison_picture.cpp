#include "tools/train_edges/comparison_picture.h"

#include <string>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "tools/train_edges/edge_score.h"

namespace tools {
namespace {

using Picture = cv::Mat_<cv::Vec3b>;

const cv::Vec3b kPaper(255, 255, 255);

/// Draws edges coloured (BGR) by cause; the cause listed last wins where several meet.
Picture draw_labels(const synth::EdgeLabels& labels) {
  const std::pair<synth::EdgeCause, cv::Vec3b> colours[] = {
      {synth::EdgeCause::albedo, {0, 150, 0}},
      {synth::EdgeCause::shadow, {200, 120, 0}},
      {synth::EdgeCause::crease, {200, 0, 160}},
      {synth::EdgeCause::depth, {0, 0, 200}}};
  Picture picture(labels.size(), kPaper);
  for (const auto& [cause, colour] : colours) {
    picture.setTo(colour, (labels & bit(cause)) != 0);
  }
  return picture;
}

Picture draw_detected(const vo::EdgeMask& edges, const synth::EdgeLabels& labels) {
  cv::Mat distance;
  cv::distanceTransform(labels == 0, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  Picture picture(edges.size(), kPaper);
  picture.setTo(cv::Vec3b(40, 40, 220), edges);
  picture.setTo(cv::Vec3b(0, 130, 0), edges & (distance <= kEdgeTolerance + 1e-3));
  return picture;
}

Picture titled(Picture picture, const std::string& title) {
  cv::rectangle(picture, cv::Rect(0, 0, picture.cols, 16), cv::Scalar::all(235), cv::FILLED);
  cv::putText(picture, title, {4, 12}, cv::FONT_HERSHEY_SIMPLEX, 0.4, cv::Scalar::all(0), 1,
              cv::LINE_AA);
  return picture;
}

}  // namespace

cv::Mat_<cv::Vec3b> draw_comparison(const std::vector<LabelledView>& views, std::size_t every,
                                    const vo::StructuredForest& forest,
                                    const std::vector<DetectorCurve>& curves) {
  const DetectorCurve& canny = curves.at(2);
  vo::EdgeOptions detectors = options_at(canny, canny.best().threshold);
  detectors.forest_strength = curves.at(0).best().threshold;
  std::vector<Picture> rows;
  for (std::size_t i = 0; i < views.size(); i += every) {
    const LabelledView& view = views[i];
    const vo::EdgeMask learnt = forest_edges(forest, vo::to_rgb(view.image), detectors.forest_scale,
                                             detectors.forest_strength);
    const vo::EdgeMask computed = vo::detect_edges(vo::to_gray(view.image), detectors);
    const std::vector<Picture> row = {
        titled(view.image.clone(), "image"),
        titled(draw_labels(view.labels), "exact edges by cause"),
        titled(draw_detected(learnt, view.labels), "structured forest"),
        titled(draw_detected(computed, view.labels), "Canny")};
    cv::hconcat(row, rows.emplace_back());
  }
  Picture picture;
  cv::vconcat(rows, picture);
  return picture;
}

}  // namespace tools
