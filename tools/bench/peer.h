#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

/// Wall-clock time of one frame by stage; the stages add up to the whole frame.
struct StageCosts {
  double pyramid_ms = 0;
  double edges_ms = 0;
  double alignment_ms = 0;
  double map_ms = 0;  ///< all else, mainly map maintenance

  double total_ms() const { return pyramid_ms + edges_ms + alignment_ms + map_ms; }
};

/// Cost and result of tracking one frame.
struct FrameSample {
  StageCosts costs;
  double cpu_ms = 0;       ///< processor time of the thread; near the wall time if idle
  std::size_t points = 0;  ///< points of the finest level in the last alignment
  bool is_keyframe = false;
  std::optional<std::size_t> map_bytes;   ///< memory of the map's images and points
  std::optional<vo::SE3> T_world_camera;  ///< empty when tracking is lost
};

/// Tracks the next frame of a sequence and measures its cost.
using FrameTracker = std::function<FrameSample(const vo::RgbdFrame& frame)>;

/// A tracker under test. Each start gives an independent run.
struct Peer {
  std::string name;
  std::function<FrameTracker(const vo::PinholeCamera& camera)> start;
};

/// Returns a peer that runs edvo's RGB-D tracker with these options.
Peer edvo_peer(const std::string& name, const vo::TrackerOptions& options);

/// A peer that was requested but cannot run, and why.
struct Absence {
  std::string name;
  std::string reason;
};

struct LineUp {
  std::vector<Peer> peers;
  std::vector<Absence> absent;
};

/// Returns the names that `--peers` accepts; "edvo" stands for all presets.
std::vector<std::string> peer_names();

/// Returns the peers of the given names, in the order of the table, and those that cannot run.
LineUp line_up(const std::vector<std::string>& peers);

/// Returns the options of preset default with these `key=value` assigned; throws vo::Error for one
/// that cannot be.
vo::TrackerOptions default_with(
    const std::vector<std::pair<std::string, std::string>>& assignments);

}  // namespace tools
