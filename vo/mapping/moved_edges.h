#pragma once

#include <vector>

#include "vo/core/instruction_set.h"
#include "vo/mapping/hypotheses.h"
#include "vo/mapping/stereo_pair.h"

namespace vo {

/// A hypothesis that is not a guess, moved to the current image.
struct MovedEdge {
  std::size_t hypothesis = 0;
  bool is_visible = false;    ///< in front of the camera and in the image
  bool is_changed = false;    ///< intensity differs from the host's
  float inverse_depth = 0;    ///< 1/m
  float variance = 0;         ///< 1/m^2
  Eigen::Vector2f position;   ///< px, in the current image
  Eigen::Vector2f direction;  ///< unit, of the gradient in the current image
};

/// Moves depth and variance as `moved_depth` does, with identical bits for all instruction sets.
std::vector<MovedEdge> move_edges(const StereoPair& pair, const Hypotheses& hypotheses,
                                  float relative_noise, InstructionSet set);

}  // namespace vo
