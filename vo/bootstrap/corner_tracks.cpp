#include "vo/bootstrap/corner_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include <Eigen/LU>

#include "vo/mapping/stereo_pair.h"

namespace vo {
namespace {

constexpr int kRadius = 4;  // px, half-width of a neighbourhood on each level
constexpr int kWidth = 2 * kRadius + 1;
constexpr int kPixels = kWidth * kWidth;
constexpr int kBorder = kRadius + 2;

/// Returns the least eigenvalue of the structure tensor, the strength of the weaker direction.
float corner_strength(const GrayImage& image, cv::Point pixel) {
  float xx = 0;
  float xy = 0;
  float yy = 0;
  for (int dv = -2; dv <= 2; ++dv) {
    for (int du = -2; du <= 2; ++du) {
      const cv::Vec2f g = central_gradient(image, pixel + cv::Point(du, dv));
      xx += g[0] * g[0];
      xy += g[0] * g[1];
      yy += g[1] * g[1];
    }
  }
  const float half = 0.5F * (xx - yy);
  return 0.5F * (xx + yy) - std::sqrt(half * half + xy * xy);
}

/// A neighbourhood in the first frame and its slopes, with their means subtracted so that
/// brightness may change.
struct Patch {
  std::array<float, kPixels> value{};
  std::array<float, kPixels> slope_u{};
  std::array<float, kPixels> slope_v{};
  Eigen::Matrix2f H_inverse;
  float squares = 0;  ///< sum of the squared values
};

bool holds_patch(const GrayImage& image, const Eigen::Vector2f& centre) {
  const auto border = static_cast<float>(kBorder);
  return centre.x() >= border && centre.y() >= border &&
         centre.x() < static_cast<float>(image.cols - 1) - border &&
         centre.y() < static_cast<float>(image.rows - 1) - border;
}

void subtract_mean(std::array<float, kPixels>& values) {
  float sum = 0;
  for (const float value : values) {
    sum += value;
  }
  for (float& value : values) {
    value -= sum / kPixels;
  }
}

std::array<float, kPixels> sample_patch(const GrayImage& image, const Eigen::Vector2f& centre) {
  std::array<float, kPixels> values{};
  std::size_t i = 0;
  for (int dv = -kRadius; dv <= kRadius; ++dv) {
    for (int du = -kRadius; du <= kRadius; ++du) {
      values[i++] = sample_bilinear(
          image, centre + Eigen::Vector2f(static_cast<float>(du), static_cast<float>(dv)));
    }
  }
  return values;
}

/// Makes a patch; returns false where the neighbourhood does not determine two directions.
bool make_patch(const GrayImage& image, const Eigen::Vector2f& centre, Patch& patch) {
  patch.value = sample_patch(image, centre);
  const auto right = sample_patch(image, centre + Eigen::Vector2f(0.5F, 0));
  const auto left = sample_patch(image, centre - Eigen::Vector2f(0.5F, 0));
  const auto below = sample_patch(image, centre + Eigen::Vector2f(0, 0.5F));
  const auto above = sample_patch(image, centre - Eigen::Vector2f(0, 0.5F));
  for (std::size_t i = 0; i < kPixels; ++i) {
    patch.slope_u[i] = right[i] - left[i];
    patch.slope_v[i] = below[i] - above[i];
  }
  subtract_mean(patch.value);
  subtract_mean(patch.slope_u);
  subtract_mean(patch.slope_v);
  Eigen::Matrix2f H = Eigen::Matrix2f::Zero();
  for (std::size_t i = 0; i < kPixels; ++i) {
    const Eigen::Vector2f slope(patch.slope_u[i], patch.slope_v[i]);
    H += slope * slope.transpose();
  }
  constexpr float kMinDeterminant = 1e-6F;
  if (!(H.determinant() > kMinDeterminant)) {
    return false;
  }
  patch.H_inverse = H.inverse();
  patch.squares =
      std::inner_product(patch.value.begin(), patch.value.end(), patch.value.begin(), 0.0F);
  return true;
}

/// Moves `centre` to where the image looks like the patch; returns the correlation of both there,
/// or -1 where the patch is lost.
float follow_patch(const Patch& patch, const GrayImage& image, Eigen::Vector2f& centre) {
  constexpr int kMaxIterations = 12;
  constexpr float kConverged = 0.01F;  // px
  float product = 0;
  float squares = 0;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    if (!holds_patch(image, centre)) {
      return -1;
    }
    std::array<float, kPixels> values = sample_patch(image, centre);
    subtract_mean(values);
    Eigen::Vector2f right = Eigen::Vector2f::Zero();
    product = 0;
    squares = 0;
    for (std::size_t i = 0; i < kPixels; ++i) {
      const float residual = values[i] - patch.value[i];
      right += residual * Eigen::Vector2f(patch.slope_u[i], patch.slope_v[i]);
      product += values[i] * patch.value[i];
      squares += values[i] * values[i];
    }
    const Eigen::Vector2f step = patch.H_inverse * right;
    centre -= step;
    if (step.norm() < kConverged) {
      break;
    }
  }
  return holds_patch(image, centre) && squares > 0 ? product / std::sqrt(squares * patch.squares)
                                                   : -1;
}

/// Returns the strongest corner of a cell of the image, if any is strong enough to be followed.
std::optional<cv::Point> strongest_corner(const GrayImage& image, const cv::Rect& cell) {
  constexpr float kMinStrength = 2e-3F;
  std::optional<cv::Point> best;
  float strongest = kMinStrength;
  for (int v = cell.y; v < cell.y + cell.height; ++v) {
    for (int u = cell.x; u < cell.x + cell.width; ++u) {
      const float strength = corner_strength(image, {u, v});
      if (strength > strongest) {
        strongest = strength;
        best = cv::Point(u, v);
      }
    }
  }
  return best;
}

}  // namespace

CornerTracks::CornerTracks(const FramePyramid& first, int count) : first_(first) {
  const GrayImage& image = first.levels.front().intensity;
  const int cell =
      std::max(4, static_cast<int>(std::sqrt(static_cast<double>(image.total()) / count)));
  for (int top = kBorder; top + cell + kBorder <= image.rows; top += cell) {
    for (int left = kBorder; left + cell + kBorder <= image.cols; left += cell) {
      if (const std::optional<cv::Point> corner =
              strongest_corner(image, {left, top, cell, cell})) {
        start_.emplace_back(corner->x, corner->y);
      }
    }
  }
  now_ = start_;
  alive_.resize(start_.size(), true);
}

void CornerTracks::follow(const FramePyramid& frame) {
  for (std::size_t i = 0; i < start_.size(); ++i) {
    alive_[i] = alive_[i] && follow_one(i, frame);
  }
}

std::size_t CornerTracks::alive() const {
  return static_cast<std::size_t>(std::count(alive_.begin(), alive_.end(), true));
}

bool CornerTracks::follow_one(std::size_t i, const FramePyramid& frame) {
  constexpr float kLeastCorrelation = 0.8F;
  constexpr double kMaxStep = 40;  // px, from frame to frame
  Eigen::Vector2d displacement = now_[i] - start_[i];
  float correlation = -1;
  for (std::size_t l = frame.levels.size(); l-- > 0;) {
    const double scale = std::ldexp(1.0, -static_cast<int>(l));
    const auto at_level = [&](const Eigen::Vector2d& pixel) -> Eigen::Vector2f {
      return ((pixel.array() + 0.5) * scale - 0.5).cast<float>().matrix();
    };
    const Eigen::Vector2f from = at_level(start_[i]);
    Eigen::Vector2f to = at_level(start_[i] + displacement);
    Patch patch;
    if (!holds_patch(first_.levels[l].intensity, from) ||
        !make_patch(first_.levels[l].intensity, from, patch)) {
      continue;
    }
    const Eigen::Vector2f before = to;
    correlation = follow_patch(patch, frame.levels[l].intensity, to);
    if (correlation >= 0) {
      displacement += (to - before).cast<double>() / scale;
    } else if (l == 0) {
      return false;
    }
  }
  const Eigen::Vector2d now = start_[i] + displacement;
  const bool found = correlation >= kLeastCorrelation && (now - now_[i]).norm() <= kMaxStep;
  now_[i] = now;
  return found;
}

}  // namespace vo
