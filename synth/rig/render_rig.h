#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synth/rig/camera_jobs.h"
#include "synth/sequence/render_plan.h"
#include "synth/sequence/render_sequence.h"
#include "vo/core/progress.h"
#include "vo/files/output.h"

namespace synth {

/// Renders a share of a rig into a folder that appears when all its frames are there, as
/// `render_sequence` says of a sequence. `cameras` are the jobs that `camera_jobs` makes of it.
/// Each camera's frames are in a folder of its name, which is that of its job, of `cameras`,
/// rendered alone; beside them are rig.toml, groundtruth.txt (T_world_body), the patterns of
/// projectors that come from files and, if the channel `imu` is asked for, the IMU's files. Frames
/// of the outcome are those of all cameras, its notes those of `notes_on_rig` and
/// `notes_on_stamps`; `observe` is called with those of the first one that
/// this call renders.
RenderOutcome render_rig(const RigJob& job, const std::vector<RenderJob>& cameras,
                         const std::filesystem::path& folder, const vo::OutputPolicy& policy,
                         const vo::Progress& progress, const MadeFrameObserver& observe = {});

/// Returns notes on what the pictures of a rig leave out: those on any of its cameras' jobs, each
/// once, and on projectors whose light shows in none of them.
std::vector<std::string> notes_on_rig(const RigJob& job, const std::vector<RenderJob>& cameras);

/// Returns a note on each camera whose frames begin before 0 s, which a time offset makes of paths
/// that begin at 0.
std::vector<std::string> notes_on_stamps(const RigJob& job, const std::vector<RenderJob>& cameras);

/// Estimates a rig's cost as `plan_sequence` does, from frames of each of its cameras.
RenderPlan plan_rig(const RigJob& job, const std::vector<RenderJob>& cameras,
                    const std::filesystem::path& folder);

}  // namespace synth
