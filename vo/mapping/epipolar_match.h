#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

#include "vo/mapping/epipolar_block.h"

/// The second half of a block's search, which finds where the current image looks like the host.
namespace vo::detail {

/// The samples of a block's lines, line after line, and one line's squared differences.
struct LineSamples {
  std::array<std::size_t, kLines> first;  // index of each line's first sample
  std::array<std::size_t, kLines>
      shifts;               // number of shifts of the host's samples; 0 unless searched
  std::vector<float> u, v;  // px
  std::vector<float> intensity;
  std::vector<float> difference;  // sum of squares at each shift, less their common offset's
};

inline constexpr std::size_t kChunk = 16;  // samples of one line that are placed at a time
inline constexpr float kUnseen = 1e9F;     // squared difference outside of the image
/// Share of the five samples' mean difference that is taken for a difference of brightness, which
/// vignette, exposure and gloss make whatever the edge. An offset of standard deviation s that five
/// samples of noise n have in common is worth 5 s^2 / (n^2 + 5 s^2) once it is marginalised: as
/// large as 0.9 n it is 0.8. What the matches themselves show is no guide: most of an offset that
/// is not allowed for becomes displacement.
inline constexpr float kCommonOffset = 0.8F;
inline constexpr double kAmbiguity = 1.5;  // least second best over best difference, long lines
inline constexpr double kMaxMatchResidual = 16;  // grey levels, RMS of five samples of a match

/// Decides which lines are searched and returns the number of samples they need. Short intervals
/// need no search, because Gauss-Newton leads to the match from anywhere in them.
EDVO_INLINE std::size_t count_samples(LineBlock& block, LineSamples& samples) {
  constexpr float kNoSearch = 1.5F;  // px
  std::size_t count = 0;
  for (std::size_t i = 0; i < kLines; ++i) {
    const float range = block.s_max[i] - block.s_min[i];
    const bool is_searched =
        block.outcome[i] == code(SearchOutcome::found) && !(range <= kNoSearch);
    samples.first[i] = count;
    samples.shifts[i] =
        is_searched ? 1 + static_cast<std::size_t>(std::ceil(range / block.step[i])) : 0;
    count += is_searched ? samples.shifts[i] + 2 * kReach : 0;
  }
  return count;
}

/// Computes the pixels of a line's samples: the searched interval and kReach samples beyond either
/// end. Up to a chunk more is written.
EDVO_INLINE void place_samples(const SearchView& view, const LineBlock& block, std::size_t i,
                               LineSamples& samples) {
  constexpr float kStraight = 8;  // px; a lens bends a line of this length by less than 0.05 px
  const std::size_t count = samples.shifts[i] + 2 * kReach;
  const float step = block.step[i];
  const float first = block.s_min[i] - static_cast<float>(kReach) * step;
  const float last = first + static_cast<float>(count - 1) * step;
  const bool straight = view.current_camera.lens.is_zero() || last - first <= kStraight;
  const float dq_x = block.dq_x[i];
  const float dq_y = block.dq_y[i];
  const float line_u = block.imaged.du_dx[i] * dq_x + block.imaged.du_dy[i] * dq_y;
  const float line_v = block.imaged.dv_dx[i] * dq_x + block.imaged.dv_dy[i] * dq_y;
  const float from_u = straight ? block.imaged.u[i] : block.q_x[i];
  const float from_v = straight ? block.imaged.v[i] : block.q_y[i];
  const float by_u = straight ? line_u : dq_x;
  const float by_v = straight ? line_v : dq_y;
  for (std::size_t start = 0; start < count; start += kChunk) {
    Lanes<kChunk> u;
    Lanes<kChunk> v;
    for (std::size_t k = 0; k < kChunk; ++k) {
      const float at = first + static_cast<float>(static_cast<int>(start + k)) * step;
      u[k] = from_u + at * by_u;
      v[k] = from_v + at * by_v;
    }
    if (!straight) {
      ImagedLanes<kChunk> imaged;
      image_lanes(view.current_camera, u, v, imaged);
      u = imaged.u;
      v = imaged.v;
    }
    std::memcpy(samples.u.data() + samples.first[i] + start, u.data(), sizeof(u));
    std::memcpy(samples.v.data() + samples.first[i] + start, v.data(), sizeof(v));
  }
}

/// Samples the current image along all lines that are searched.
EDVO_INLINE void sample_current(const SearchView& view, const LineBlock& block, std::size_t count,
                                LineSamples& samples) {
  const std::size_t room = count + kLines;
  samples.u.resize(std::max(samples.u.size(), room));
  samples.v.resize(samples.u.size());
  samples.intensity.resize(samples.u.size());
  for (std::size_t i = 0; i < kLines; ++i) {
    if (samples.shifts[i] > 0) {
      place_samples(view, block, i, samples);
    }
  }
  for (std::size_t start = 0; start < count; start += kLines) {
    LineRow u;
    LineRow v;
    LineRow intensity;
    std::memcpy(u.data(), samples.u.data() + start, sizeof(u));
    std::memcpy(v.data(), samples.v.data() + start, sizeof(v));
    sample_lanes(view.current, u, v, std::numeric_limits<float>::quiet_NaN(), intensity);
    std::memcpy(samples.intensity.data() + start, intensity.data(), sizeof(intensity));
  }
}

/// Values at eight shifts of one line.
using Octet = float __attribute__((vector_size(32)));

/// Computes the squared differences at each shift along a line. Up to seven more are written.
EDVO_INLINE void compare_line(const LineBlock& block, std::size_t i, LineSamples& samples) {
  constexpr float share = kCommonOffset / kCompared;
  constexpr std::size_t kShifts = sizeof(Octet) / sizeof(float);
  const float* intensity = samples.intensity.data() + samples.first[i];
  samples.difference.resize(std::max(samples.difference.size(), samples.shifts[i] + kShifts));
  for (std::size_t start = 0; start < samples.shifts[i]; start += kShifts) {
    Octet sum{};
    Octet total{};
    for (std::size_t k = 0; k < kCompared; ++k) {
      Octet away;
      std::memcpy(&away, intensity + start + k, sizeof(away));
      away -= block.host_intensity[k + 1][i];
      sum += away * away;
      total += away;
    }
    sum -= total * total * share;
    sum = sum < kUnseen ? sum : Octet{} + kUnseen;
    std::memcpy(samples.difference.data() + start, &sum, sizeof(sum));
  }
}

/// Returns whether another place on the line looks nearly as much like the edge as the best one.
inline bool is_ambiguous(const EpipolarOptions& options, const float* difference,
                         std::size_t shifts, std::size_t best) {
  const float noise = static_cast<float>(options.sigma_grey) * kGreyLevel;
  const float limit =
      static_cast<float>(kAmbiguity) * std::max(difference[best], 2 * kCompared * noise * noise);
  for (std::size_t i = 0; i < shifts; ++i) {
    const bool is_apart = i + 1 < best || i > best + 1;
    const bool is_least = (i == 0 || difference[i] <= difference[i - 1]) &&
                          (i + 1 == shifts || difference[i] <= difference[i + 1]);
    if (is_apart && is_least && difference[i] < limit) {
      return true;
    }
  }
  return false;
}

/// Finds the place on the line, in steps of a sample, with the least sum of squared differences.
EDVO_INLINE void match_line(const SearchView& view, std::size_t i, LineSamples& samples,
                            LineBlock& block) {
  constexpr float kLongLine = 6;  // px
  compare_line(block, i, samples);
  const std::size_t shifts = samples.shifts[i];
  const float* difference = samples.difference.data();
  const auto best =
      static_cast<std::size_t>(std::min_element(difference, difference + shifts) - difference);
  if (difference[best] >= kUnseen) {
    block.outcome[i] = code(SearchOutcome::out_of_view);
  } else if (block.s_max[i] - block.s_min[i] > kLongLine &&
             is_ambiguous(view.options, difference, shifts, best)) {
    block.outcome[i] = code(SearchOutcome::ambiguous);
  }
  block.s[i] = block.s_min[i] + static_cast<float>(best) * block.step[i];
}

EDVO_INLINE void match_lines(const SearchView& view, LineSamples& samples, LineBlock& block) {
  sample_current(view, block, count_samples(block, samples), samples);
  for (std::size_t i = 0; i < kLines; ++i) {
    if (samples.shifts[i] > 0) {
      match_line(view, i, samples, block);
    } else {
      block.s[i] = std::min(std::max(0.0F, block.s_min[i]), block.s_max[i]);
    }
  }
}

/// The pixels along lines near one place on each, to first order; exact without lens distortion.
struct LinePixels {
  LineRow start;  // px, that place on the line
  LineRow u, v;
  LineRow direction_u, direction_v;
};

EDVO_INLINE void straighten_lines(const SearchView& view, const LineBlock& block,
                                  LinePixels& pixels) {
  ImagedLanes<kLines> imaged = block.imaged;
  const bool is_perfect = view.current_camera.lens.is_zero();
  if (!is_perfect) {
    LineRow x;
    LineRow y;
    for (std::size_t i = 0; i < kLines; ++i) {
      x[i] = block.q_x[i] + block.s[i] * block.dq_x[i];
      y[i] = block.q_y[i] + block.s[i] * block.dq_y[i];
    }
    image_lanes(view.current_camera, x, y, imaged);
  }
  for (std::size_t i = 0; i < kLines; ++i) {
    const float dq_x = block.dq_x[i];
    const float dq_y = block.dq_y[i];
    const float s = is_perfect ? block.s[i] : 0;
    pixels.start[i] = block.s[i];
    pixels.u[i] = imaged.u[i] + (s * imaged.du_dx[i] * dq_x + s * imaged.du_dy[i] * dq_y);
    pixels.v[i] = imaged.v[i] + (s * imaged.dv_dx[i] * dq_x + s * imaged.dv_dy[i] * dq_y);
    pixels.direction_u[i] = imaged.du_dx[i] * dq_x + imaged.du_dy[i] * dq_y;
    pixels.direction_v[i] = imaged.dv_dx[i] * dq_x + imaged.dv_dy[i] * dq_y;
  }
}

/// The current image's samples at and around the matches.
struct LineView {
  std::array<LineRow, kSampled> intensity;
  LineFlags inside;
};

EDVO_INLINE void sample_lines(const SearchView& view, const LineBlock& block,
                              const LinePixels& pixels, LineView& seen) {
  seen.inside.fill(1);
  LineRow u;
  LineRow v;
  for (std::size_t k = 0; k < kSampled; ++k) {
    const auto away = static_cast<float>(static_cast<int>(k) - kReach - 1);
    for (std::size_t i = 0; i < kLines; ++i) {
      const float at = block.s[i] + away * block.step[i] - pixels.start[i];
      u[i] = pixels.u[i] + at * pixels.direction_u[i];
      v[i] = pixels.v[i] + at * pixels.direction_v[i];
    }
    sample_lanes(view.current, u, v, 0, seen.intensity[k]);
    for (std::size_t i = 0; i < kLines; ++i) {
      seen.inside[i] = view.current.bounds.holds(u[i], v[i]) ? seen.inside[i] : 0;
    }
  }
}

/// The normal equations of s and the squared residuals, summed over a line's compared samples, the
/// samples' common offset marginalised.
struct LineSums {
  LineRow information, right, squares;
};

/// Sums the terms of all lines; slopes are the mean of both images' slopes.
EDVO_INLINE void sum_lines(const LineView& seen, const LineBlock& block, LineSums& sums) {
  sums = {};
  LineRow slope_sum{};
  LineRow residual_sum{};
  for (std::size_t k = 1; k + 1 < kSampled; ++k) {
    for (std::size_t i = 0; i < kLines; ++i) {
      const float slope = 0.25F / block.step[i] *
                          ((seen.intensity[k + 1][i] - seen.intensity[k - 1][i]) +
                           (block.host_intensity[k + 1][i] - block.host_intensity[k - 1][i]));
      const float residual = seen.intensity[k][i] - block.host_intensity[k][i];
      sums.information[i] += slope * slope;
      sums.right[i] += slope * residual;
      sums.squares[i] += residual * residual;
      slope_sum[i] += slope;
      residual_sum[i] += residual;
    }
  }
  constexpr float share = kCommonOffset / kCompared;
  for (std::size_t i = 0; i < kLines; ++i) {
    sums.information[i] -= share * slope_sum[i] * slope_sum[i];
    sums.right[i] -= share * slope_sum[i] * residual_sum[i];
    sums.squares[i] -= share * residual_sum[i] * residual_sum[i];
  }
}

/// Takes a Gauss-Newton step of s on the lines still moving; returns how many still move after it.
EDVO_INLINE std::int32_t step_lines(const LineView& seen, LineBlock& block, LineFlags& moving) {
  constexpr float kMaxStep = 0.5F;
  constexpr float kConverged = 0.01F;
  LineSums sums;
  sum_lines(seen, block, sums);
  for (std::size_t i = 0; i < kLines; ++i) {
    const float information = sums.information[i];
    const float step = std::min(std::max(-sums.right[i] / information, -kMaxStep), kMaxStep);
    const bool is_moving = moving[i] > 0;
    const bool is_lost = seen.inside[i] == 0 || !(information > 0);
    block.information[i] = is_moving ? information : block.information[i];
    block.squares[i] = is_moving ? sums.squares[i] : block.squares[i];
    block.s[i] += is_moving && !is_lost ? step : 0;
    rule_out(is_moving && is_lost, SearchOutcome::no_match, block.outcome[i]);
    moving[i] = is_lost || std::abs(step) < kConverged ? 0 : moving[i];
  }
  return std::accumulate(moving.begin(), moving.end(), std::int32_t{0});
}

/// Refines matches to a fraction of a sample. An edge that strays from the searched place, or where
/// the images disagree, has no match.
EDVO_INLINE void refine_lines(const SearchView& view, LineBlock& block) {
  constexpr int kMaxIterations = 4;
  LinePixels pixels;
  straighten_lines(view, block, pixels);
  LineFlags moving;
  for (std::size_t i = 0; i < kLines; ++i) {
    moving[i] = block.outcome[i] == code(SearchOutcome::found) ? 1 : 0;
  }
  std::int32_t left = 1;
  for (int iteration = 0; iteration < kMaxIterations && left > 0; ++iteration) {
    LineView seen;
    sample_lines(view, block, pixels, seen);
    left = step_lines(seen, block, moving);
  }
  const float limit = static_cast<float>(kMaxMatchResidual) * kGreyLevel;
  constexpr float kMisplaced2 = 0.1F;  // px^2, displacement by interpolation on strong edges
  for (std::size_t i = 0; i < kLines; ++i) {
    const float limit2 = static_cast<float>(kCompared) * limit * limit;
    const float moved = std::abs(block.s[i] - pixels.start[i]);
    const float may_move = 1.5F * std::max(block.step[i], 1.0F);
    const bool is_match =
        (block.squares[i] <= limit2 + kMisplaced2 * block.information[i]) & (moved <= may_move);
    rule_out(!is_match, SearchOutcome::no_match, block.outcome[i]);
  }
}

}  // namespace vo::detail
