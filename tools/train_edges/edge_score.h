#pragma once

#include <array>
#include <cstddef>

#include "synth/truth/edge_labels.h"
#include "vo/core/image.h"

namespace tools {

inline constexpr double kEdgeTolerance = 2;  ///< greatest distance of matching edge pixels, px

/// Sizes of a detected and a labelled pixel set and how many of each lie within 2 px of the other.
/// Pixels are not matched one to one: thick detections are not penalised, so compare thin ones.
struct EdgeScore {
  static constexpr std::size_t kCauses = enum_names(synth::EdgeCause::depth).size();

  std::size_t detected = 0;
  std::size_t detected_right = 0;
  std::size_t labelled = 0;
  std::size_t labelled_found = 0;
  std::array<std::size_t, kCauses> caused{};  ///< number of labelled pixels by EdgeCause
  std::array<std::size_t, kCauses> caused_found{};

  EdgeScore& operator+=(const EdgeScore& other);

  double precision() const;  ///< share of detections that are right; 1 without any
  double recall() const;     ///< share of labels that are found; 1 without any
  double recall_of(synth::EdgeCause cause) const;
  double f_measure() const;  ///< harmonic mean of precision and recall
};

EdgeScore score_edges(const vo::EdgeMask& detected, const synth::EdgeLabels& labels);

}  // namespace tools
