#pragma once

#include <span>

#include "vo/alignment/align_result.h"
#include "vo/alignment/joint_problem.h"
#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/align_options.h"

namespace vo {

/// Finds the pose that agrees best with all references by Gauss-Newton on SE(3), coarse to fine;
/// steps that raise the cost are undone. Pure: identical input gives identical output.
AlignResult align(std::span<const AlignReference> references, const AlignCurrent& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options);

/// Aligns in memory that is kept from frame to frame, to the same bits.
AlignResult align(std::span<const AlignReference> references, const AlignCurrent& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options, AlignMemory& memory);

/// Aligns a frame to a single reference.
AlignResult align(const EdgePoints& reference, const FramePyramid& current,
                  const SE3& T_cur_ref_guess, const AlignOptions& options);

}  // namespace vo
