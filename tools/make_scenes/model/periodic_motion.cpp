#include "tools/make_scenes/model/periodic_motion.h"

#include <numbers>

namespace scenes {

Motion periodic_motion(int node, const Period& period,
                       const std::function<Eigen::Isometry3d(double phase)>& T_parent_node) {
  Motion motion = {node, {}, {}};
  for (int i = 0; i <= period.steps; ++i) {
    motion.times.push_back(period.duration * i / period.steps);
    motion.T_parent_node.push_back(T_parent_node(2 * std::numbers::pi * i / period.steps));
  }
  return motion;
}

}  // namespace scenes
