#include "tools/depth/depth_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "tools/depth/true_depth.h"
#include "tools/pictures/panels.h"
#include "vo/core/error.h"

namespace tools {
namespace {

using Picture = cv::Mat_<cv::Vec3b>;

const cv::Vec3b kBackground(40, 40, 40);

/// A colour map over a range of values.
struct ColourScale {
  double low = 0;
  double high = 1;
  std::string unit;
  cv::Mat_<cv::Vec3b> colours;  ///< column of 256 colours

  ColourScale(double least, double greatest, std::string name_of_unit, int map)
      : low(least), high(greatest), unit(std::move(name_of_unit)) {
    cv::Mat_<uchar> ramp(256, 1);
    for (int i = 0; i < 256; ++i) {
      ramp(i, 0) = static_cast<uchar>(i);
    }
    cv::Mat coloured;
    cv::applyColorMap(ramp, coloured, map);
    colours = coloured;
  }

  cv::Vec3b operator()(double value) const {
    const double share = (value - low) / std::max(high - low, 1e-12);
    return colours(static_cast<int>(255 * std::clamp(share, 0.0, 1.0)), 0);
  }
};

std::string labelled(double value, const std::string& unit) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f%s", value, unit.c_str());
  return text.data();
}

/// Returns the picture with a labelled colour bar on its right.
Picture with_bar(const Picture& picture, const ColourScale& scale) {
  constexpr int kBar = 14;    // px
  constexpr int kPaper = 78;  // px
  constexpr int kTop = 30;    // px
  constexpr int kTicks = 5;
  Picture wide(picture.rows, picture.cols + kPaper, cv::Vec3b(255, 255, 255));
  picture.copyTo(wide.colRange(0, picture.cols));
  const int height = picture.rows - 2 * kTop;
  for (int v = 0; v < height; ++v) {
    const double value = scale.high + (scale.low - scale.high) * v / (height - 1);
    wide.row(kTop + v).colRange(picture.cols + 4, picture.cols + 4 + kBar) = scale(value);
  }
  for (int tick = 0; tick < kTicks; ++tick) {
    const double share = tick / (kTicks - 1.0);
    cv::putText(wide, labelled(scale.high + (scale.low - scale.high) * share, scale.unit),
                {picture.cols + kBar + 8, kTop + 4 + static_cast<int>(share * (height - 1))},
                cv::FONT_HERSHEY_SIMPLEX, 0.35, cv::Scalar(30, 30, 30), 1, cv::LINE_AA);
  }
  return wide;
}

/// Draws a point of 2x2 pixels, so that it is visible.
void put_point(Picture& picture, cv::Point pixel, const cv::Vec3b& colour) {
  picture(cv::Rect(pixel, cv::Size(2, 2)) & cv::Rect({0, 0}, picture.size())).setTo(colour);
}

std::vector<std::size_t> confident_hypotheses(const vo::DepthMap& map) {
  std::vector<std::size_t> chosen;
  const vo::Hypotheses& hypotheses = map.hypotheses();
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.is_confident(i, vo::kConfidentSigma)) {
      chosen.push_back(i);
    }
  }
  return chosen;
}

/// Returns the 2nd and 98th percentile of the true depths at the hypotheses, m.
std::pair<double, double> depth_range(const vo::DepthMap& map, const vo::DepthImage& true_depth) {
  std::vector<float> depths;
  for (const cv::Point& pixel : map.hypotheses().pixel) {
    if (vo::has_depth(true_depth(pixel))) {
      depths.push_back(true_depth(pixel));
    }
  }
  if (depths.empty()) {
    return {0, 1};
  }
  std::sort(depths.begin(), depths.end());
  return {depths[depths.size() / 50], depths[depths.size() - 1 - depths.size() / 50]};
}

}  // namespace

cv::Mat_<cv::Vec3b> draw_depth_map(const vo::DepthMap& map, const vo::DepthImage& true_depth,
                                   double scale) {
  constexpr double kFullError = 0.05;
  const auto [nearest, farthest] = depth_range(map, true_depth);
  const ColourScale depths(nearest, farthest, " m", cv::COLORMAP_VIRIDIS);
  const ColourScale errors(-100 * kFullError, 100 * kFullError, " %", cv::COLORMAP_JET);
  Picture truth(true_depth.size(), kBackground);
  Picture estimate = truth.clone();
  Picture error = truth.clone();
  const SparseDepths sparse = sparse_depths(map, true_depth, scale);
  for (const cv::Point& pixel : map.hypotheses().pixel) {
    if (vo::has_depth(sparse.truth(pixel))) {
      put_point(estimate, pixel, depths(sparse.estimate(pixel)));
      put_point(truth, pixel, depths(sparse.truth(pixel)));
      put_point(error, pixel, errors(100 * (sparse.estimate(pixel) / sparse.truth(pixel) - 1)));
    }
  }
  return montage({{titled(with_bar(truth, depths), "true depth"),
                   titled(with_bar(estimate, depths), "estimated depth"),
                   titled(with_bar(error, errors), "relative error")}});
}

SparseDepths sparse_depths(const vo::DepthMap& map, const vo::DepthImage& true_depth,
                           double scale) {
  SparseDepths sparse{vo::DepthImage(true_depth.size(), 0.0F),
                      vo::DepthImage(true_depth.size(), 0.0F)};
  const vo::Hypotheses& hypotheses = map.hypotheses();
  for (const std::size_t i : confident_hypotheses(map)) {
    const cv::Point pixel = hypotheses.pixel[i];
    const double estimate = hypotheses.smoothed[i] / scale;
    const double truth = nearest_true_inverse_depth(true_depth, pixel, estimate);
    if (truth > 0) {
      sparse.estimate(pixel) = static_cast<float>(1 / estimate);
      sparse.truth(pixel) = static_cast<float>(1 / truth);
    }
  }
  return sparse;
}

EdgeCloud cloud_of(const vo::DepthMap& map, const vo::SE3& T_world_host) {
  const vo::Hypotheses& hypotheses = map.hypotheses();
  const vo::PyramidLevel& level = map.host().levels.front();
  EdgeCloud cloud;
  for (const std::size_t i : confident_hypotheses(map)) {
    const cv::Vec2f edge = hypotheses.edge_position(i);
    const Eigen::Vector3d p_world =
        T_world_host *
        level.camera.unproject({edge[0], edge[1]}, 1 / static_cast<double>(hypotheses.smoothed[i]));
    cloud.push_back({.p_world = p_world.cast<float>(),
                     .grey = grey_of(level.intensity(hypotheses.pixel[i])),
                     .inverse_depth_sigma = std::sqrt(hypotheses.smoothed_variance[i])});
  }
  return cloud;
}

}  // namespace tools
