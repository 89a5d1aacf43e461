#include "vo/mapping/stereo_pair.h"

namespace vo {
namespace {

/// Returns the matrix of the cross product w x.
Eigen::Matrix3f cross_matrix(const Eigen::Vector3f& w) {
  Eigen::Matrix3f matrix;
  matrix << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return matrix;
}

/// Returns A * B. Eigen's own product adds the first two terms first where its packets hold two
/// floats (NEON), and the last two first where they hold four.
template <int kColumns>
Eigen::Matrix<float, 3, kColumns> product(const Eigen::Matrix3f& A,
                                          const Eigen::Matrix<float, 3, kColumns>& B) {
  Eigen::Matrix<float, 3, kColumns> result;
  for (Eigen::Index c = 0; c < kColumns; ++c) {
    for (Eigen::Index r = 0; r < 3; ++r) {
      result(r, c) = A(r, 0) * B(0, c) + (A(r, 1) * B(1, c) + A(r, 2) * B(2, c));
    }
  }
  return result;
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
  const Eigen::Matrix3f turn_back = -cross_matrix(relation.current_motion.angular);
  by_host_line << product(R, cross_matrix(host.angular)), product(R, host.linear);
  by_current_line = product(turn_back, of_middle);
  by_current_line.col(3) -= relation.current_motion.linear;
  by_both = product(turn_back, by_host_line);
}

}  // namespace vo
