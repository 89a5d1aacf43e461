#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace vo {

/// The policy that decides when hypotheses move to a new host.
enum class PropagationPolicy {
  keyframe,  ///< when the view has changed enough; until then the host stays
  always,    ///< at every frame, "at each new time step" as the paper has it
};

constexpr auto enum_names(PropagationPolicy) {
  return std::array{std::pair{PropagationPolicy::keyframe, "keyframe"},
                    std::pair{PropagationPolicy::always, "always"}};
}

/// The method by which an observation changes a hypothesis.
enum class Fusion {
  gaussian,       ///< normal distributions; inconsistent observations are refused
  gaussian_beta,  ///< Vogiatzis & Hernandez, "Video-based, real-time multi-view stereo", 2011
};

constexpr auto enum_names(Fusion) {
  return std::array{std::pair{Fusion::gaussian, "gaussian"},
                    std::pair{Fusion::gaussian_beta, "gaussian_beta"}};
}

enum class Regularisation {
  none,
  chains,  ///< smoothing along the edge with neighbours that agree
};

constexpr auto enum_names(Regularisation) {
  return std::array{std::pair{Regularisation::none, "none"},
                    std::pair{Regularisation::chains, "chains"}};
}

/// The search for an edge along its epipolar line and the noise that gives a match its variance.
struct EpipolarOptions {
  double search_sigmas = 2;       ///< half the searched interval, standard deviations
  double max_search_px = 60;      ///< px, longest line that is searched
  double min_parallax_px = 0.3;   ///< px, least parallax at the expected depth
  double min_gradient = 2;        ///< least gradient along the line, grey levels per 2 px
  double min_cos2 = 0.3;          ///< least squared cosine of gradient and line
  double max_scale_change = 1.5;  ///< most scale change of the neighbourhood, either way
  double max_residual = 16;       ///< grey levels, RMS of five samples; more is no match
  double ambiguity = 1.5;         ///< least second best over best squared difference, long lines
  double sigma_offset_px = 0.15;  ///< px, sigma of the edge in the host, common to all frames
  double sigma_line_px = 0.11;    ///< px, sigma of the line's position across itself
  double sigma_match_px = 0.11;   ///< px, sigma of the match along the line
  double sigma_grey = 2;          ///< grey levels, sigma of an intensity

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, EpipolarOptions& options) {
  visit("search_sigmas", options.search_sigmas, "half the searched interval, standard deviations");
  visit("max_search_px", options.max_search_px, "longest line searched, px");
  visit("min_parallax_px", options.min_parallax_px, "less at the expected depth tells nothing, px");
  visit("min_gradient", options.min_gradient, "along the line, grey levels per 2 px");
  visit("min_cos2", options.min_cos2, "squared cosine of gradient and line");
  visit("max_scale_change", options.max_scale_change, "of the neighbourhood between the images");
  visit("max_residual", options.max_residual, "RMS of five samples, grey levels");
  visit("ambiguity", options.ambiguity, "second best over best squared difference");
  visit("sigma_offset_px", options.sigma_offset_px,
        "of the edge in the host keyframe, alike in all frames, px");
  visit("sigma_line_px", options.sigma_line_px, "of the line across itself, px");
  visit("sigma_match_px", options.sigma_match_px, "of the match along the line, px");
  visit("sigma_grey", options.sigma_grey, "of an intensity, grey levels");
}

/// The change of the view at which the next frame becomes the host.
struct HostOptions {
  int every = 0;             ///< frames from host to host; 0 is by view alone
  double max_flow = 0.06;    ///< most mean displacement of the edges, image widths
  double min_overlap = 0.7;  ///< least share of the edges in view

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, HostOptions& options) {
  visit("every", options.every, "frames from host to host; 0 is by view alone");
  visit("max_flow", options.max_flow, "a new one beyond this mean displacement, image widths");
  visit("min_overlap", options.min_overlap, "a new one below this share of edges in view");
}

struct DepthMapOptions {
  PropagationPolicy propagate = PropagationPolicy::keyframe;
  Fusion fusion = Fusion::gaussian;
  Regularisation regularise = Regularisation::chains;
  int max_hypotheses = 8000;         ///< most hypotheses per host, spread evenly; 0 is no limit
  double min_depth = 0.25;           ///< m, nearest depth searched where nothing is known
  double max_depth = 20;             ///< m, farthest depth searched where nothing is known
  double gate_sigmas = 3;            ///< standard deviations; a farther observation is refused
  double min_sigma = 0.001;          ///< least relative sigma of an inverse depth
  double propagation_sigma = 0.002;  ///< relative sigma added when the host changes
  double confident_sigma = 0.1;      ///< relative; hypotheses up to it are used for tracking
  int max_failures = 3;              ///< surplus of failures over successes that deletes
  double fill_sigma = 0.05;          ///< relative sigma of a pixel filled from its neighbours
  std::uint64_t seed = 0;            ///< seed of the choice of edge pixels under the limit
  HostOptions host;
  EpipolarOptions epipolar;

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, DepthMapOptions& options) {
  visit("propagate", options.propagate, "when hypotheses move to a new frame");
  visit("fusion", options.fusion, "how an observation changes a hypothesis");
  visit("regularise", options.regularise, "which neighbours smooth a depth");
  visit("max_hypotheses", options.max_hypotheses, "per frame, spread evenly; 0 is no limit");
  visit("min_depth", options.min_depth, "searched from, where nothing is known, m");
  visit("max_depth", options.max_depth, "searched to, where nothing is known, m");
  visit("gate_sigmas", options.gate_sigmas, "an observation farther off is refused");
  visit("min_sigma", options.min_sigma, "least relative standard deviation of an inverse depth");
  visit("propagation_sigma", options.propagation_sigma, "relative, added when the host changes");
  visit("confident_sigma", options.confident_sigma, "relative; below it used for tracking");
  visit("max_failures", options.max_failures, "more failures than successes: deleted");
  visit("fill_sigma", options.fill_sigma, "relative, of a pixel filled from its neighbours");
  visit("seed", options.seed, "of which edge pixels the limit leaves");
  visit("host", options.host, "");
  visit("epipolar", options.epipolar, "");
}

}  // namespace vo
