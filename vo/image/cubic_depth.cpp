#include "vo/image/cubic_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vo {
namespace {

/// The four pixels along an axis that one pixel of the halved image is interpolated from.
struct Taps {
  std::array<int, 4> at;         ///< px
  std::array<float, 4> weights;  ///< sum 1
};

/// Returns Keys' weights of the pixels at -1, 0, 1 and 2 for a place in [0, 1).
std::array<float, 4> cubic_weights(float place) {
  constexpr float kA = -0.75F;
  const auto within_one = [](float x) { return ((kA + 2) * x - (kA + 3)) * x * x + 1; };
  const float beyond = place + 1;
  std::array<float, 4> weights = {
      ((kA * beyond - 5 * kA) * beyond + 8 * kA) * beyond - 4 * kA,
      within_one(place),
      within_one(1 - place),
  };
  weights[3] = 1 - weights[0] - weights[1] - weights[2];
  return weights;
}

std::vector<Taps> taps_of(int size, int half_size) {
  const double scale = 1 / (static_cast<double>(half_size) / size);
  std::vector<Taps> taps;
  for (int i = 0; i < half_size; ++i) {
    const auto place = static_cast<float>((i + 0.5) * scale - 0.5);
    const int before = static_cast<int>(std::floor(place));
    Taps& added = taps.emplace_back();
    added.weights = cubic_weights(place - static_cast<float>(before));
    for (int k = 0; k < 4; ++k) {
      added.at.at(static_cast<std::size_t>(k)) = std::clamp(before - 1 + k, 0, size - 1);
    }
  }
  return taps;
}

/// Returns the image with its rows interpolated.
DepthImage narrowed(const DepthImage& depth, int cols) {
  const std::vector<Taps> taps = taps_of(depth.cols, cols);
  DepthImage narrow(depth.rows, cols);
  for (int v = 0; v < depth.rows; ++v) {
    const float* const row = depth[v];
    for (int u = 0; u < cols; ++u) {
      const auto& [at, w] = taps[static_cast<std::size_t>(u)];
      narrow(v, u) = row[at[0]] * w[0] + row[at[1]] * w[1] + row[at[2]] * w[2] + row[at[3]] * w[3];
    }
  }
  return narrow;
}

}  // namespace

/// Adds rows from the last one, as cv::resize does in most columns on x86-64.
void halve_cubic(const DepthImage& depth, DepthImage& half) {
  make_writable(half, {depth.cols / 2, depth.rows / 2});
  if (half.empty()) {
    return;
  }
  const DepthImage narrow = narrowed(depth, half.cols);
  const std::vector<Taps> taps = taps_of(depth.rows, half.rows);
  for (int v = 0; v < half.rows; ++v) {
    const auto& [at, w] = taps[static_cast<std::size_t>(v)];
    const std::array<const float*, 4> rows = {narrow[at[0]], narrow[at[1]], narrow[at[2]],
                                              narrow[at[3]]};
    for (int u = 0; u < half.cols; ++u) {
      half(v, u) =
          rows[0][u] * w[0] + (rows[1][u] * w[1] + (rows[2][u] * w[2] + rows[3][u] * w[3]));
    }
  }
}

}  // namespace vo
