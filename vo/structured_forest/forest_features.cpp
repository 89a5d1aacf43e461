#include "vo/structured_forest/forest_features.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"
#include "vo/structured_forest/luv.h"
#include "vo/structured_forest/triangle_filter.h"

namespace vo {
namespace {

cv::Mat resized(const cv::Mat& image, const cv::Size& size) {
  cv::Mat result;
  const bool is_smaller = size.width < image.cols && size.height < image.rows;
  cv::resize(image, result, size, 0, 0, is_smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
  return result;
}

cv::Size scaled(const cv::Size& size, float scale) {
  return {cvRound(scale * static_cast<float>(size.width)),
          cvRound(scale * static_cast<float>(size.height))};
}

/// Gradient of the colour channel where it is strongest, for each pixel.
struct Gradient {
  cv::Mat_<float> magnitude;
  cv::Mat_<float> direction;  ///< 0..1 for 0..pi
};

float direction_of(const cv::Vec2f& gradient) {
  if (std::abs(gradient[0]) + std::abs(gradient[1]) < 1e-5F) {
    return 0.5F;
  }
  const float turn = cv::fastAtan2(gradient[1], gradient[0]) / 180;
  return gradient[1] < 0 ? turn - 1 : turn;
}

cv::Vec2f strongest(const cv::Vec3f& dx, const cv::Vec3f& dy) {
  cv::Vec2f best(0, 0);
  float best_square = -1;
  for (int channel = 0; channel < 3; ++channel) {
    const float square = dx[channel] * dx[channel] + dy[channel] * dy[channel];
    if (square > best_square) {
      best_square = square;
      best = {dx[channel], dy[channel]};
    }
  }
  return best;
}

/// Returns the gradient, its magnitude divided by the mean over a triangle of radius
/// `normalization`, px.
Gradient gradient_of(const cv::Mat_<cv::Vec3f>& image, int normalization) {
  cv::Mat_<cv::Vec3f> dx;
  cv::Mat_<cv::Vec3f> dy;
  cv::Sobel(image, dx, CV_32F, 1, 0, 1, 1, 0, cv::BORDER_REFLECT);
  cv::Sobel(image, dy, CV_32F, 0, 1, 1, 1, 0, cv::BORDER_REFLECT);
  Gradient gradient{cv::Mat_<float>(image.size()), cv::Mat_<float>(image.size())};
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const cv::Vec2f g = strongest(dx(v, u), dy(v, u));
      gradient.magnitude(v, u) = std::sqrt(g[0] * g[0] + g[1] * g[1]);
      gradient.direction(v, u) = direction_of(g);
    }
  }
  const cv::Mat mean = smoothed_by_triangle(gradient.magnitude, normalization) + 0.01;
  gradient.magnitude /= mean;
  return gradient;
}

/// Returns gradient magnitudes by direction in `bins` channels, averaged over cells of `cell` px.
cv::Mat orientation_histogram(const Gradient& gradient, int bins, int cell) {
  const cv::Size size((gradient.magnitude.cols + cell - 1) / cell,
                      (gradient.magnitude.rows + cell - 1) / cell);
  cv::Mat histogram(size, CV_32FC(bins), cv::Scalar::all(0));
  const auto area = static_cast<float>(cell * cell);
  for (int v = 0; v < gradient.magnitude.rows; ++v) {
    auto* row = histogram.ptr<float>(v / cell);
    for (int u = 0; u < gradient.magnitude.cols; ++u) {
      const int bin = cvRound(gradient.direction(v, u) * static_cast<float>(bins)) % bins;
      row[u / cell * bins + bin] += gradient.magnitude(v, u) / area;
    }
  }
  return histogram;
}

cv::Mat channels_of(const cv::Mat_<cv::Vec3f>& luv, const ForestParameters& parameters) {
  const cv::Size size = scaled(luv.size(), 1 / static_cast<float>(parameters.shrink));
  std::vector<cv::Mat> channels = {resized(luv, size)};
  for (const float scale : {1.0F, 0.5F}) {
    const cv::Mat image = smoothed_by_triangle(resized(luv, scaled(luv.size(), scale)),
                                               parameters.gradient_smoothing);
    const Gradient gradient = gradient_of(image, parameters.gradient_normalization);
    const int cell = std::max(1, static_cast<int>(static_cast<float>(parameters.shrink) * scale));
    channels.push_back(resized(gradient.magnitude, size));
    channels.push_back(
        resized(orientation_histogram(gradient, parameters.orientations, cell), size));
  }
  cv::Mat merged;
  cv::merge(channels, merged);
  return merged;
}

int smoothing_radius(int radius_px, int shrink) {
  return cvRound(static_cast<float>(radius_px) / static_cast<float>(shrink));
}

/// Returns the positions of the grid's cells along a patch, in feature pixels.
std::vector<std::size_t> grid_positions(const ForestParameters& parameters) {
  const int side = parameters.patch_size / parameters.shrink;
  const int half_cell = cvRound(side / (2.0 * parameters.grid_size));
  std::vector<std::size_t> positions;
  for (int i = 0; i < parameters.grid_size; ++i) {
    const double position =
        (i + 1) * (side + 2 * half_cell - 1) / (parameters.grid_size + 1.0) - half_cell + 0.5;
    positions.push_back(
        static_cast<std::size_t>(std::clamp(static_cast<int>(position), 0, side - 1)));
  }
  return positions;
}

void require_within(const char* name, int value, int least, int most) {
  require(value >= least && value <= most, name, ": expected ", least, " to ", most, ", got ",
          value);
}

}  // namespace

void ForestParameters::validate() const {
  require_within("shrinkNumber", shrink, 1, 8);
  require_within("patchSize", patch_size, 2 * shrink, 128);
  require_within("patchInnerSize", inner_size, 2, patch_size);
  require(patch_size % shrink == 0, "patchSize: expected a multiple of shrinkNumber, got ",
          patch_size);
  require((patch_size - inner_size) % 2 == 0,
          "patchInnerSize: expected to leave an even border of patchSize, got ", inner_size);
  require_within("stride", stride, 1, inner_size);
  require_within("numberOfGradientOrientations", orientations, 1, 32);
  require_within("gradientSmoothingRadius", gradient_smoothing, 0, 64);
  require_within("regFeatureSmoothingRadius", regular_smoothing, 0, 64);
  require_within("ssFeatureSmoothingRadius", similarity_smoothing, 0, 64);
  require_within("gradientNormalizationRadius", gradient_normalization, 0, 64);
  require_within("selfsimilarityGridSize", grid_size, 1, patch_size / shrink);
  require_within("numberOfTrees", trees, 1, 1000);
  require_within("numberOfTreesToEvaluate", trees_to_evaluate, 1, trees);
}

ForestFeatures forest_features(const cv::Mat_<cv::Vec3f>& rgb, const ForestParameters& parameters) {
  const int padding = parameters.padding();
  cv::Mat_<cv::Vec3f> padded;
  cv::copyMakeBorder(rgb, padded, padding, padding, padding, padding, cv::BORDER_REFLECT);
  const cv::Mat channels = channels_of(rgb_to_luv(padded), parameters);
  return {smoothed_by_triangle(channels,
                               smoothing_radius(parameters.regular_smoothing, parameters.shrink)),
          smoothed_by_triangle(
              channels, smoothing_radius(parameters.similarity_smoothing, parameters.shrink))};
}

cv::Size patch_grid(const cv::Size& image, const ForestParameters& parameters) {
  const auto along = [&](int length) {
    const int padded = length + 2 * parameters.padding();
    const int shrunk = cvRound(static_cast<float>(padded) / static_cast<float>(parameters.shrink));
    const int room = std::min(shrunk * parameters.shrink - parameters.patch_size,
                              length - parameters.inner_size + 1);
    return std::max(0, (room + parameters.stride - 1) / parameters.stride);
  };
  return {along(image.width), along(image.height)};
}

FeatureIndex::FeatureIndex(const ForestParameters& parameters, std::size_t step) {
  const auto side = static_cast<std::size_t>(parameters.patch_size / parameters.shrink);
  const auto channels = static_cast<std::size_t>(parameters.channels());
  for (std::size_t channel = 0; channel < channels; ++channel) {
    for (std::size_t u = 0; u < side; ++u) {
      for (std::size_t v = 0; v < side; ++v) {
        regular_.push_back(v * step + u * channels + channel);
      }
    }
  }
  std::vector<std::size_t> cells;
  const std::vector<std::size_t> positions = grid_positions(parameters);
  for (const std::size_t u : positions) {
    for (const std::size_t v : positions) {
      cells.push_back(v * step + u * channels);
    }
  }
  for (std::size_t channel = 0; channel < channels; ++channel) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (std::size_t j = i + 1; j < cells.size(); ++j) {
        pairs_.push_back({cells[i] + channel, cells[j] + channel});
      }
    }
  }
}

int feature_count(const ForestParameters& parameters) {
  return FeatureIndex(parameters, 0).size();
}

}  // namespace vo
