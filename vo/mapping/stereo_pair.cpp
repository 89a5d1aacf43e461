#include "vo/mapping/stereo_pair.h"

namespace vo {
namespace {

/// Returns the matrix of the cross product w x.
Eigen::Matrix3f cross_matrix(const Eigen::Vector3f& w) {
  Eigen::Matrix3f matrix;
  matrix << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return matrix;
}

}  // namespace

LineTransforms::LineTransforms(const FrameRelation& relation)
    : is_rolling(!relation.host_motion.is_zero() || !relation.current_motion.is_zero()),
      host_axis(relation.host_motion.axis),
      current_axis(relation.current_motion.axis) {
  const Eigen::Matrix3f R = relation.T_cur_host.rotation_matrix().cast<float>();
  of_middle << R, relation.T_cur_host.translation().cast<float>();
  if (!is_rolling) {
    return;
  }
  const ReadoutMotion& host = relation.host_motion;
  const Eigen::Matrix3f turn = cross_matrix(relation.current_motion.angular);
  by_host_line << R * cross_matrix(host.angular), R * host.linear;
  by_current_line = -turn * of_middle;
  by_current_line.col(3) -= relation.current_motion.linear;
  by_both = -turn * by_host_line;
}

}  // namespace vo
