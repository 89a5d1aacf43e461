#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace vo {

/// When hypotheses move to a new host.
enum class PropagationPolicy {
  keyframe,  ///< when the view has changed enough; between them the host stays
  always,    ///< every frame, "at each new time step" as the paper has it
};

constexpr auto enum_names(PropagationPolicy) {
  return std::array{std::pair{PropagationPolicy::keyframe, "keyframe"},
                    std::pair{PropagationPolicy::always, "always"}};
}

/// How an observation changes a hypothesis.
enum class Fusion {
  gaussian,       ///< product of two normal distributions, inconsistent ones refused
  gaussian_beta,  ///< Vogiatzis & Hernandez, "Video-based, real-time multi-view stereo", 2011
};

constexpr auto enum_names(Fusion) {
  return std::array{std::pair{Fusion::gaussian, "gaussian"},
                    std::pair{Fusion::gaussian_beta, "gaussian_beta"}};
}

enum class Regularisation {
  none,
  chains,  ///< neighbours along the edge that agree
};

constexpr auto enum_names(Regularisation) {
  return std::array{std::pair{Regularisation::none, "none"},
                    std::pair{Regularisation::chains, "chains"}};
}

/// How an edge is looked for along its epipolar line, and what the match is worth.
struct EpipolarOptions {
  double search_sigmas = 2;       ///< half the searched interval, standard deviations
  double max_search_px = 60;      ///< of a line
  double min_parallax_px = 0.3;   ///< at the expected depth; less tells nothing
  double min_gradient = 2;        ///< along the line, grey levels per 2 px
  double min_cos2 = 0.3;          ///< of the angle between gradient and line
  double max_scale_change = 1.5;  ///< of the neighbourhood from frame to frame, either way
  double max_residual = 16;       ///< grey levels, RMS of five samples; more is no match
  double ambiguity = 1.5;         ///< second best over best squared difference, on longer lines
  double sigma_offset_px = 0.15;  ///< of the edge in the host, the same for all frames
  double sigma_line_px = 0.11;    ///< of the line's position across itself
  double sigma_match_px = 0.11;   ///< of the match along the line
  double sigma_grey = 2;          ///< grey levels, of an intensity

  void validate() const;  ///< throws Error
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

/// When the view has changed so much that the next frame becomes the host.
struct HostOptions {
  int every = 0;             ///< frames; 0 is by view alone
  double max_flow = 0.06;    ///< mean displacement of the edges, image widths
  double min_overlap = 0.7;  ///< share of the edges in view

  void validate() const;  ///< throws Error
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
  int max_hypotheses = 8000;         ///< per host, spread evenly; 0 is no limit
  double min_depth = 0.25;           ///< m, where nothing is known yet
  double max_depth = 20;             ///< m
  double gate_sigmas = 3;            ///< an observation farther off is refused
  double min_sigma = 0.001;          ///< of an inverse depth, relative: what no averaging removes
  double propagation_sigma = 0.002;  ///< relative, added when the host changes
  double confident_sigma = 0.1;      ///< relative; a hypothesis below it is used for tracking
  int max_failures = 3;              ///< more failed than successful observations: deleted
  double fill_sigma = 0.05;          ///< relative, of an edge pixel filled from its neighbours
  std::uint64_t seed = 0;            ///< of which edge pixels the limit leaves
  HostOptions host;
  EpipolarOptions epipolar;

  void validate() const;  ///< throws Error
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
