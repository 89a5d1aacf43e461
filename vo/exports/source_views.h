#pragma once

#include <string>
#include <string_view>

#include "vo/dataset/sequence_source.h"

namespace vo {

/// Returns a sequence without the frames that have no pose, and a note that says how many those
/// were. Throws Error, which begins with `place` and names `format`, if no frame has one.
SequenceSource frames_with_poses(SequenceSource source, const std::string& place,
                                 std::string_view format);

/// Returns a sequence as a camera without lens distortion takes it, and a note that gives its
/// intrinsics. `format` is the one that has no such lens.
SequenceSource undistorted(SequenceSource source, std::string_view format);

/// Returns a sequence in a world with another axis up: poses and the body's states are turned.
/// Where its own is unknown it stays as it is, with a note if it has poses.
SequenceSource in_world(SequenceSource source, WorldUp up);

}  // namespace vo
