#pragma once

#include <array>
#include <cstddef>

#include "synth/truth/edge_labels.h"
#include "vo/core/image.h"

namespace tools {

inline constexpr double kEdgeTolerance = 2;  ///< px

/// How many pixels two sets have, and how many of them lie within 2 px of the other set. Pixels are
/// not paired one to one: detections that are thick are not punished, so compare thin ones.
struct EdgeScore {
  static constexpr std::size_t kCauses = enum_names(synth::EdgeCause::depth).size();

  std::size_t detected = 0;
  std::size_t detected_right = 0;
  std::size_t labelled = 0;
  std::size_t labelled_found = 0;
  std::array<std::size_t, kCauses> caused{};  ///< labelled, by EdgeCause
  std::array<std::size_t, kCauses> caused_found{};

  EdgeScore& operator+=(const EdgeScore& other);

  double precision() const;  ///< 1 where nothing is detected
  double recall() const;     ///< 1 where nothing is labelled
  double recall_of(synth::EdgeCause cause) const;
  double f_measure() const;  ///< harmonic mean of precision and recall
};

EdgeScore score_edges(const vo::EdgeMask& detected, const synth::EdgeLabels& labels);

}  // namespace tools
