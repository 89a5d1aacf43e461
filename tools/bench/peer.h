#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

/// Wall-clock time of one frame by stage; the stages are the whole frame.
struct StageCosts {
  double pyramid_ms = 0;
  double edges_ms = 0;
  double alignment_ms = 0;
  double map_ms = 0;  ///< what is left: keeping the frames that later ones are aligned to

  double total_ms() const { return pyramid_ms + edges_ms + alignment_ms + map_ms; }
};

/// What tracking one frame cost and gave.
struct FrameSample {
  StageCosts costs;
  double cpu_ms = 0;       ///< of the thread: the same as the costs on an idle machine
  std::size_t points = 0;  ///< of the finest level, in the last alignment
  bool is_keyframe = false;
  std::optional<std::size_t> map_bytes;   ///< images and points of what is kept; if known
  std::optional<vo::SE3> T_world_camera;  ///< nothing when lost
};

/// Tracks the next frame of a sequence and takes the time of it.
using FrameTracker = std::function<FrameSample(const vo::RgbdFrame& frame)>;

/// Something that tracks a camera. Each start is independent of the ones before.
struct Peer {
  std::string name;
  std::function<FrameTracker(const vo::PinholeCamera& camera)> start;
};

/// Our tracker with these options.
Peer edvo_peer(const std::string& name, const vo::TrackerOptions& options);

/// Who was asked for and cannot run, and why.
struct Absence {
  std::string name;
  std::string reason;
};

struct LineUp {
  std::vector<Peer> peers;
  std::vector<Absence> absent;
};

/// What `--peers` may name: edvo is all our presets.
std::vector<std::string> peer_names();

/// The peers of these peers, in the order of the table.
LineUp line_up(const std::vector<std::string>& peers);

}  // namespace tools
