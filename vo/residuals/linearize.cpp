#include "vo/residuals/linearize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "vo/residuals/intensity_moments.h"
#include "vo/residuals/median_magnitude.h"
#include "vo/residuals/point_sampler.h"

namespace vo {
namespace {

constexpr double kMinLossScale = 1.5 / 255;  ///< intensity; a smaller spread of residuals is noise

PassOptions pass_options(const AlignOptions& options, const ResidualModel& model) {
  const float reference_share = options.formulation == Formulation::forward   ? 0.0F
                                : options.formulation == Formulation::inverse ? 1.0F
                                                                              : 0.5F;
  return {.loss = options.loss,
          .loss_scale = static_cast<float>(model.scale),
          .squared_weights = options.squared_weights,
          .gain = static_cast<float>(model.brightness.gain),
          .offset = static_cast<float>(model.brightness.offset),
          .current_share = 1 - reference_share,
          .reference_share = reference_share,
          .inverse_variance = static_cast<float>(options.depth_noise * options.depth_noise /
                                                 (model.scale * model.scale)),
          .max_depth_ratio = static_cast<float>(options.max_depth_ratio),
          .brightness = options.brightness == BrightnessModel::affine};
}

/// Number of points that tells a median or a mean of their intensities well enough.
constexpr std::size_t kEnoughPoints = 600;

/// Returns of how many blocks of points one is looked up, so that there are enough points.
std::size_t stride_of(const PointView& view) {
  return 1 + view.points.size() / kEnoughPoints;
}

/// Returns the moments of the points' intensities and those of the image where they are seen, of
/// every `stride`-th block of points.
IntensityMoments moments_of(const PointView& view, std::size_t stride) {
  PointSampler sampler(view, available_instruction_set(), 0, stride);
  IntensityMoments moments;
  for (std::size_t block = 0; block < sampler.blocks(); block += stride) {
    const float* reference = view.points.intensity.data() + PointSampler::first_of(block);
    for (const float seen : sampler.sample(block).intensity) {
      if (!std::isnan(seen)) {
        moments.add(*reference, seen);
      }
      ++reference;
    }
  }
  return moments;
}

/// Returns 1.4826 times the median |r|, intensity: the standard deviation of Gaussian residuals,
/// hardly changed by outliers. Of many points it takes some 600, evenly spread.
double residual_spread(const PointView& view, const Brightness& brightness) {
  const auto gain = static_cast<float>(brightness.gain);
  const auto offset = static_cast<float>(brightness.offset);
  const std::size_t stride = stride_of(view);
  std::array<float, kEnoughPoints + detail::kBlock> magnitudes;
  std::size_t count = 0;
  PointSampler sampler(view, available_instruction_set(), 0, stride);
  for (std::size_t block = 0; block < sampler.blocks(); block += stride) {
    const float* reference = view.points.intensity.data() + PointSampler::first_of(block);
    for (const float seen : sampler.sample(block).intensity) {
      if (!std::isnan(seen)) {
        magnitudes[count++] = std::abs(seen - (gain * *reference + offset));
      }
      ++reference;
    }
  }
  return robust_sigma_of({magnitudes.data(), count});
}

}  // namespace

PointEquations linearize(const PointView& view, const AlignOptions& options,
                         const ResidualModel& model) {
  constexpr double kPrior = 1e-3;  // information about gain and offset for each point
  PointEquations equations =
      sum_points(view, pass_options(options, model), available_instruction_set());
  equations.H.diagonal().tail<kBrightnessParameters>().array() +=
      kPrior * static_cast<double>(equations.points + 1);
  return equations;
}

void compute_point_terms(const PointView& view, const AlignOptions& options,
                         const ResidualModel& model, PointTerms& scores) {
  compute_point_terms(view, pass_options(options, model), available_instruction_set(), scores);
}

std::vector<float> sampled_intensities(const PointView& view) {
  std::vector<float> intensities;
  intensities.reserve(view.points.size());
  PointSampler sampler(view, available_instruction_set());
  for (std::size_t block = 0; block < sampler.blocks(); ++block) {
    const std::span<const float> seen = sampler.sample(block).intensity;
    intensities.insert(intensities.end(), seen.begin(), seen.end());
  }
  return intensities;
}

std::vector<std::optional<float>> residuals(const EdgePointLevel& reference,
                                            const PyramidLevel& current, const SE3& T_cur_ref) {
  const std::vector<float> seen = sampled_intensities({reference, current, T_cur_ref, {}, {}});
  std::vector<std::optional<float>> result(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!std::isnan(seen[i])) {
      result[i] = seen[i] - reference.intensity[i];
    }
  }
  return result;
}

double correlation(const PointView& view) {
  return moments_of(view, 1).correlation();
}

Brightness matched_brightness(const PointView& view) {
  const IntensityMoments m = moments_of(view, stride_of(view));
  if (!(m.ref_variance() > 0) || !(m.cur_variance() > 0)) {
    return {};
  }
  const double gain = std::sqrt(m.cur_variance() / m.ref_variance());
  return {gain, (m.cur - gain * m.ref) / m.n};
}

double shown_scale(const PointView& view, const Brightness& brightness,
                   const AlignOptions& options) {
  return std::max(efficient_scale(options.loss) * residual_spread(view, brightness), kMinLossScale);
}

}  // namespace vo
