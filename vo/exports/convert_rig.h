#pragma once

#include "vo/core/progress.h"
#include "vo/exports/convert_sequence.h"
#include "vo/files/output.h"

namespace vo {

/// Converts the folder of a rig to EuRoC's layout, in a folder that appears when it is complete:
/// mav0/camK for its K-th camera, with T_BS its pose in the body, and imu0 and
/// state_groundtruth_estimate0 of the body. Cameras that are no pinholes are left out with a note;
/// K counts the others. Throws Error for other formats, which hold one camera, and for a rig
/// without a pinhole.
ConvertOutcome convert_rig(const ConvertJob& job, const OutputPolicy& policy,
                           const Progress& progress);

}  // namespace vo
