#pragma once

#include <vector>

#include "vo/core/instruction_set.h"
#include "vo/mapping/hypotheses.h"
#include "vo/mapping/stereo_pair.h"

namespace vo {

/// A hypothesis of the host of which something is known, and where it is in the current image.
struct MovedEdge {
  std::size_t hypothesis = 0;
  bool is_visible = false;    ///< in front of the camera and in the image
  bool is_changed = false;    ///< the image shows another intensity there than the host
  float inverse_depth = 0;    ///< 1/m
  float variance = 0;         ///< 1/m^2
  Eigen::Vector2f position;   ///< px
  Eigen::Vector2f direction;  ///< unit, of the gradient
};

/// Depth and its variance move as `moved_depth` says; the same bits with all instructions.
std::vector<MovedEdge> move_edges(const StereoPair& pair, const Hypotheses& hypotheses,
                                  float relative_noise, InstructionSet set);

}  // namespace vo
