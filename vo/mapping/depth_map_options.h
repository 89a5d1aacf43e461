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

/// The noise that gives a match along an epipolar line its variance.
struct EpipolarOptions {
  double sigma_offset_px = 0.15;  ///< px, sigma of the edge in the host, common to all frames
  double sigma_line_px = 0.11;    ///< px, sigma of the line's position across itself
  double sigma_match_px = 0.11;   ///< px, sigma of the match along the line
  double sigma_grey = 2;          ///< grey levels, sigma of an intensity

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, EpipolarOptions& options) {
  visit("sigma_offset_px", options.sigma_offset_px,
        "of the edge in the host keyframe, alike in all frames, px");
  visit("sigma_line_px", options.sigma_line_px, "of the line across itself, px");
  visit("sigma_match_px", options.sigma_match_px, "of the match along the line, px");
  visit("sigma_grey", options.sigma_grey, "of an intensity, grey levels");
}

/// The change of the view at which the next frame becomes the host.
struct HostOptions {
  int every = 0;           ///< frames from host to host; 0 is by view alone
  double max_flow = 0.06;  ///< most mean displacement of the edges, image widths

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, HostOptions& options) {
  visit("every", options.every, "frames from host to host; 0 is by view alone");
  visit("max_flow", options.max_flow, "a new one beyond this mean displacement, image widths");
}

/// Relative standard deviation of an inverse depth; hypotheses up to it are used for tracking.
inline constexpr double kConfidentSigma = 0.1;

struct DepthMapOptions {
  PropagationPolicy propagate = PropagationPolicy::keyframe;
  Fusion fusion = Fusion::gaussian;
  Regularisation regularise = Regularisation::chains;
  int max_hypotheses = 8000;  ///< most hypotheses per host, spread evenly; 0 is no limit
  double min_depth = 0.25;    ///< m, nearest depth searched where nothing is known
  double max_depth = 20;      ///< m, farthest depth searched where nothing is known
  double gate_sigmas = 3;     ///< standard deviations; a farther observation is refused
  std::uint64_t seed = 0;     ///< seed of the choice of edge pixels under the limit
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
  visit("seed", options.seed, "of which edge pixels the limit leaves");
  visit("host", options.host, "");
  visit("epipolar", options.epipolar, "");
}

}  // namespace vo
