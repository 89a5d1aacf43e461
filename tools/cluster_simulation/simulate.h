#pragma once

#include <cstddef>
#include <vector>

#include "tools/cluster_simulation/cluster_options.h"
#include "tools/cluster_simulation/cluster_run.h"
#include "vo/core/progress.h"

namespace tools {

/// Returns what an array job comes to that makes parts of so many frames each, in order, some to a
/// task. A task is put on the first node that has room, loads a scene and makes its parts one after
/// the other; when its node fails, the parts that are done stay and the rest is queued again,
/// behind what waits. The same options give the same run. Throws vo::Error where nodes fail so
/// often that the parts are never done.
ClusterRun simulate_cluster(const ClusterOptions& options,
                            const std::vector<std::size_t>& frames_of_parts,
                            const vo::WaitObserver& waiting = {});

}  // namespace tools
