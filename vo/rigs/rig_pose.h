#pragma once

#include <string>
#include <vector>

#include "vo/core/fields.h"
#include "vo/geometry/se3.h"

namespace vo {

/// A pose as a rig's file has it: a matrix, or a position and an orientation; empty where the file
/// is silent.
struct PoseValues {
  std::vector<double> matrix;  ///< four rows
  std::vector<double> position;
  std::vector<double> orientation;  ///< x, y, z, w
};

/// Returns a field that takes `count` numbers into a vector.
Field numbers_field(const std::string& key, const char* help, std::size_t count,
                    std::vector<double>& values);

/// Adds the fields of a pose, whose matrix has the key `matrix`, to those of a table.
void add_pose_fields(const std::string& prefix, const std::string& matrix, PoseValues& pose,
                     std::vector<Field>& fields);

/// Returns the pose that a file gives, the identity where it gives none. Throws Error, which begins
/// with `place`, if it is no pose or given twice.
SE3 pose_of(const std::string& place, const std::string& matrix, const PoseValues& values);

/// Returns a pose as TOML, four rows of a matrix.
std::string format_pose(const std::string& key, const SE3& T);

}  // namespace vo
