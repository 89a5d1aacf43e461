#include "synth/denoising/light_fit.h"

#include <algorithm>
#include <cstddef>
#include <memory>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "synth/denoising/likeness.h"
#include "vo/core/instruction_set.h"

namespace synth {
namespace {

constexpr int kReach = 6;                 // px, of the window that a pixel's light is fitted in
constexpr int kEdge = 16;                 // px, of a tile
constexpr int kBorder = kReach + kPatch;  // px, around the planes
constexpr int kPatchedEdge = kEdge + 2 * kPatch;  // px, of a tile with its patches
constexpr float kPatchSize = (2 * kPatch + 1) * (2 * kPatch + 1);
constexpr int kTerms = 7;  // of the linear function: one, normal, nearness, column, row
constexpr int kProducts = kTerms * (kTerms + 1) / 2;

// The ridges are added to the diagonal of the normal equations, relative to the sum of the weights.
constexpr double kSurfaceRidge = 0.003;  // of normal and nearness
constexpr double kPlaceRidge = 0.3;      // of column and row

// Scales of what makes pixels alike, each of which lowers a pixel's weight to 1/e.
constexpr float kNormalScale = 0.2F;
constexpr float kNearnessScale = 0.1F;
constexpr float kReflectanceScale = 0.2F;
constexpr float kLeastWeight =
    0.01F;  // by surfaces; counts where none around is alike, as on edges

using Row = std::array<float, kEdge>;
using Square = std::array<Row, kEdge>;
using Difference = std::array<std::array<float, kPatchedEdge>, kPatchedEdge>;

/// The normal equations of one half of the samples, for each pixel of a tile.
struct NormalEquations {
  std::array<Square, kProducts> products;                ///< of two terms, the upper triangle
  std::array<std::array<Square, kTerms>, 3> right_side;  ///< of each channel
};

/// A Tile has a part of the picture and its normal equations.
struct Tile {
  const LightPlanes* planes;
  const Plane* inside;  ///< 1 in the picture, 0 in its border
  cv::Point corner;     ///< in the planes
  std::array<NormalEquations, 2> halves;
};

/// Computes the weights of the pixels at an offset by normal, nearness and reflectance.
EDVO_INLINE void compare_surfaces(const Tile& tile, const cv::Point& offset, Square& weights) {
  const LightPlanes& planes = *tile.planes;
  for (int y = 0; y < kEdge; ++y) {
    const int v = tile.corner.y + y;
    Row apart{};
    const auto add = [&](const Plane& plane, float scale, Row& sum) EDVO_INLINE_LAMBDA {
      const float* here = plane[v] + tile.corner.x;
      const float* there = plane[v + offset.y] + tile.corner.x + offset.x;
      for (int x = 0; x < kEdge; ++x) {
        const float difference = (there[x] - here[x]) * scale;
        sum[static_cast<std::size_t>(x)] += difference * difference;
      }
    };
    Row turned{};
    Row tinted{};
    for (std::size_t i = 0; i < 3; ++i) {
      add(planes.normal[i], 1 / kNormalScale, turned);
      add(planes.reflectance[i], 0.57735F / kReflectanceScale, tinted);  // mean of three channels
    }
    add(planes.nearness, 1 / kNearnessScale, apart);
    const float* inside = (*tile.inside)[v + offset.y] + tile.corner.x + offset.x;
    Row& weight = weights[static_cast<std::size_t>(y)];
    for (std::size_t x = 0; x < kEdge; ++x) {
      weight[x] = inside[x] * std::max(kLeastWeight,
                                       falling(std::max(apart[x], std::max(turned[x], tinted[x]))));
    }
  }
}

/// Returns how much more the light of a half differs at an offset than by its noise, of the pixels
/// of a tile and around.
EDVO_INLINE void compare_light(const Tile& tile, std::size_t half, const cv::Point& offset,
                               Difference& difference) {
  const LightPlanes& planes = *tile.planes;
  for (int y = 0; y < kPatchedEdge; ++y) {
    const int v = tile.corner.y - kPatch + y;
    const int u = tile.corner.x - kPatch;
    auto& row = difference[static_cast<std::size_t>(y)];
    row.fill(0);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const float* here = planes.light[half][channel][v] + u;
      const float* there = planes.light[half][channel][v + offset.y] + u + offset.x;
      const float* variance = planes.variance[channel][v] + u;
      const float* other = planes.variance[channel][v + offset.y] + u + offset.x;
      for (std::size_t x = 0; x < kPatchedEdge; ++x) {
        row[x] += difference_beyond_noise({here[x], variance[x]}, {there[x], other[x]});
      }
    }
  }
}

/// Lowers the weights by the mean differences of the patches around the pixels.
EDVO_INLINE void weigh_patches(const Difference& difference, Square& weights) {
  std::array<Row, kPatchedEdge> across;
  for (std::size_t y = 0; y < kPatchedEdge; ++y) {
    Row sum{};
    for (std::size_t i = 0; i <= 2 * kPatch; ++i) {
      for (std::size_t x = 0; x < kEdge; ++x) {
        sum[x] += difference[y][x + i];
      }
    }
    across[y] = sum;
  }
  for (std::size_t y = 0; y < kEdge; ++y) {
    Row sum{};
    for (std::size_t i = 0; i <= 2 * kPatch; ++i) {
      for (std::size_t x = 0; x < kEdge; ++x) {
        sum[x] += across[y + i][x];
      }
    }
    for (std::size_t x = 0; x < kEdge; ++x) {
      weights[y][x] *= falling(std::max(0.0F, sum[x] * (1 / (3 * kPatchSize))));
    }
  }
}

using Terms = std::array<Row, kTerms>;

/// Returns the terms of the linear function at an offset, for a row of a tile.
EDVO_INLINE Terms terms_of_row(const Tile& tile, const cv::Point& offset, int y) {
  const LightPlanes& planes = *tile.planes;
  const int v = tile.corner.y + y;
  Terms terms;
  terms[0].fill(1);
  const auto set = [&](const Plane& plane, Row& row) EDVO_INLINE_LAMBDA {
    const float* here = plane[v] + tile.corner.x;
    const float* there = plane[v + offset.y] + tile.corner.x + offset.x;
    for (std::size_t x = 0; x < kEdge; ++x) {
      row[x] = there[x] - here[x];
    }
  };
  set(planes.normal[0], terms[1]);
  set(planes.normal[1], terms[2]);
  set(planes.normal[2], terms[3]);
  set(planes.nearness, terms[4]);
  terms[5].fill(static_cast<float>(offset.x) / (2 * kReach));
  terms[6].fill(static_cast<float>(offset.y) / (2 * kReach));
  return terms;
}

/// Adds the products of two rows to a third.
EDVO_INLINE void add_products(const Row& weighted, const float* values, Row& sum) {
  for (std::size_t x = 0; x < kEdge; ++x) {
    sum[x] += weighted[x] * values[x];
  }
}

/// Adds the pixels at an offset, whose light is that of `half`, to the normal equations.
EDVO_INLINE void add_pixels(Tile& tile, std::size_t half, const cv::Point& offset,
                            const Square& weights) {
  NormalEquations& equations = tile.halves[half];
  for (std::size_t y = 0; y < kEdge; ++y) {
    const int v = tile.corner.y + static_cast<int>(y);
    const Terms terms = terms_of_row(tile, offset, static_cast<int>(y));
    std::size_t product = 0;
    for (std::size_t i = 0; i < kTerms; ++i) {
      Row weighted;
      for (std::size_t x = 0; x < kEdge; ++x) {
        weighted[x] = weights[y][x] * terms[i][x];
      }
      for (std::size_t j = i; j < kTerms; ++j, ++product) {
        add_products(weighted, terms[j].data(), equations.products[product][y]);
      }
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const float* light =
            tile.planes->light[half][channel][v + offset.y] + tile.corner.x + offset.x;
        add_products(weighted, light, equations.right_side[channel][i][y]);
      }
    }
  }
}

/// Sums the normal equations of a tile over the window, each half with weights by the other.
EDVO_INLINE void sum_window(Tile& tile) {
  Square by_surface;
  Square weights;
  Difference difference;
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      compare_surfaces(tile, {dx, dy}, by_surface);
      for (std::size_t half = 0; half < 2; ++half) {
        compare_light(tile, 1 - half, {dx, dy}, difference);
        weights = by_surface;
        weigh_patches(difference, weights);
        add_pixels(tile, half, {dx, dy}, weights);
      }
    }
  }
}

void sum_window_baseline(Tile& tile) {
  sum_window(tile);
}

EDVO_TARGET_AVX2 void sum_window_avx2(Tile& tile) {
  sum_window(tile);
}

EDVO_TARGET_AVX512 void sum_window_avx512(Tile& tile) {
  sum_window(tile);
}

/// Returns the light at a pixel of a tile, where all terms but the first are 0.
Eigen::Vector3f solve_pixel(const NormalEquations& equations, std::size_t y, std::size_t x) {
  Eigen::Matrix<double, kTerms, kTerms> matrix;
  Eigen::Matrix<double, kTerms, 3> right_side;
  std::size_t product = 0;
  for (int i = 0; i < kTerms; ++i) {
    for (int j = i; j < kTerms; ++j, ++product) {
      matrix(i, j) = equations.products[product][y][x];
      matrix(j, i) = matrix(i, j);
    }
    for (int channel = 0; channel < 3; ++channel) {
      right_side(i, channel) =
          equations
              .right_side[static_cast<std::size_t>(channel)][static_cast<std::size_t>(i)][y][x];
    }
  }
  matrix.diagonal().segment<4>(1).array() += kSurfaceRidge * matrix(0, 0);
  matrix.diagonal().tail<2>().array() += kPlaceRidge * matrix(0, 0);
  return matrix.llt().solve(right_side).row(0).cast<float>().transpose().cwiseMax(0);
}

Plane with_border(const Plane& plane) {
  Plane wider;
  cv::copyMakeBorder(plane, wider, kBorder, kBorder + kEdge, kBorder, kBorder + kEdge,
                     cv::BORDER_REPLICATE);
  return wider;
}

LightPlanes with_border(const LightPlanes& planes) {
  LightPlanes wider;
  for (std::size_t i = 0; i < 3; ++i) {
    wider.light[0][i] = with_border(planes.light[0][i]);
    wider.light[1][i] = with_border(planes.light[1][i]);
    wider.variance[i] = with_border(planes.variance[i]);
    wider.normal[i] = with_border(planes.normal[i]);
    wider.reflectance[i] = with_border(planes.reflectance[i]);
  }
  wider.nearness = with_border(planes.nearness);
  return wider;
}

using FittedLight = std::array<std::array<Plane, 3>, 2>;

/// Solves the normal equations of a half for a tile's pixels that are in the picture.
void solve_tile(const NormalEquations& equations, const cv::Rect& tile,
                std::array<Plane, 3>& fitted) {
  for (int y = 0; y < tile.height; ++y) {
    for (int x = 0; x < tile.width; ++x) {
      const Eigen::Vector3f light =
          solve_pixel(equations, static_cast<std::size_t>(y), static_cast<std::size_t>(x));
      for (std::size_t channel = 0; channel < 3; ++channel) {
        fitted[channel](tile.y + y, tile.x + x) = light[static_cast<Eigen::Index>(channel)];
      }
    }
  }
}

FittedLight new_light(const cv::Size& size) {
  FittedLight fitted;
  for (auto& half : fitted) {
    for (Plane& plane : half) {
      plane.create(size);
    }
  }
  return fitted;
}

}  // namespace

std::array<std::array<Plane, 3>, 2> fitted_light(const LightPlanes& planes) {
  const cv::Rect picture({0, 0}, planes.nearness.size());
  const LightPlanes wider = with_border(planes);
  Plane inside(wider.nearness.size(), 0.0F);
  inside(picture + cv::Point(kBorder, kBorder)).setTo(1);
  FittedLight fitted = new_light(picture.size());
  const auto sum = vo::version_for(vo::available_instruction_set(), &sum_window_baseline,
                                   &sum_window_avx2, &sum_window_avx512);
  const auto tile = std::make_unique<Tile>();
  for (int top = 0; top < picture.height; top += kEdge) {
    for (int left = 0; left < picture.width; left += kEdge) {
      *tile = {&wider, &inside, {left + kBorder, top + kBorder}, {}};
      sum(*tile);
      for (std::size_t half = 0; half < 2; ++half) {
        solve_tile(tile->halves[half], cv::Rect(left, top, kEdge, kEdge) & picture, fitted[half]);
      }
    }
  }
  return fitted;
}

}  // namespace synth
