#include "tools/bench/peer.h"

#include <algorithm>
#include <memory>

#include <opencv2/core/utility.hpp>

#include "tools/bench/opencv_peer.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/stopwatch.h"
#include "vo/odometry/mono_odometry.h"
#include "vo/tracking/tracker.h"

namespace tools {
namespace {

constexpr const char* kMono = "mono";

/// One of edvo's own peers: a preset and the options that differ from it.
struct EdvoRow {
  std::string name;
  std::string peer;  ///< name of the peer in `--peers`
  vo::TrackerPreset preset;
  std::vector<std::pair<std::string, std::string>> assignments;
};

std::vector<EdvoRow> edvo_rows() {
  return {
      {"paper", "edvo", vo::TrackerPreset::paper, {}},
      {"default", "edvo", vo::TrackerPreset::best_measured, {}},
      {"default-single", "edvo", vo::TrackerPreset::best_measured, {{"map.references", "1"}}},
      {"dense",
       "dense",
       vo::TrackerPreset::best_measured,
       {{"points.selection", "all"}, {"points.max_points", "0"}}},
  };
}

/// Converts the odometry's stage times; the map gets the time that no other stage accounts for.
StageCosts stage_costs(const vo::StageTimes& times, double total_ms) {
  const double before_map_ms = times.pyramid_ms + times.edges_ms + times.alignment_ms;
  return {.pyramid_ms = times.pyramid_ms,
          .edges_ms = times.edges_ms,
          .alignment_ms = times.alignment_ms,
          .map_ms = std::max(0.0, total_ms - before_map_ms)};
}

const vo::TrackingResult& tracking_of(const vo::TrackingResult& result) {
  return result;
}

const vo::TrackingResult& tracking_of(const vo::MonoResult& result) {
  return result.tracking;
}

template <typename Odometry>
FrameSample track_frame(Odometry& odometry, const vo::RgbdFrame& frame) {
  const vo::CpuStopwatch cpu_watch;
  vo::Stopwatch watch;
  const auto result = odometry.track(frame);
  const double total_ms = watch.lap_ms();
  const vo::TrackingResult& tracking = tracking_of(result);
  FrameSample sample{.costs = stage_costs(odometry.stage_times(), total_ms),
                     .cpu_ms = cpu_watch.elapsed_ms(),
                     .points = tracking.alignment.points,
                     .is_keyframe = tracking.is_keyframe,
                     .map_bytes = odometry.tracker().map().memory_bytes()};
  if (tracking.status != vo::TrackingStatus::lost) {
    sample.T_world_camera = tracking.T_world_camera;
  }
  return sample;
}

/// Returns the monocular odometry, which reads only the first frame's depth.
Peer mono_peer() {
  return {kMono, [](const vo::PinholeCamera& camera) {
            vo::MonoOptions options = vo::mono_options();
            options.bootstrap = vo::MonoBootstrap::rgbd;
            const auto odometry = std::make_shared<vo::MonoOdometry>(camera, options);
            return [odometry](const vo::RgbdFrame& frame) { return track_frame(*odometry, frame); };
          }};
}

/// Lets OpenCV work with this many threads while it lives.
class OpencvThreads {
 public:
  explicit OpencvThreads(int threads) : before_(cv::getNumThreads()) {
    if (threads != before_) {
      cv::setNumThreads(threads);
    }
  }
  OpencvThreads(const OpencvThreads&) = delete;
  OpencvThreads& operator=(const OpencvThreads&) = delete;
  ~OpencvThreads() {
    if (cv::getNumThreads() != before_) {
      cv::setNumThreads(before_);
    }
  }

 private:
  int before_;
};

vo::TrackerOptions options_of(vo::TrackerPreset preset,
                              const std::vector<std::pair<std::string, std::string>>& assignments) {
  vo::TrackerOptions options = vo::preset_options(preset);
  std::vector<vo::Field> fields = vo::fields_of(options);
  for (const auto& [key, value] : assignments) {
    vo::set_field(fields, key, value);
  }
  options.validate();
  return options;
}

/// Returns the peer of a row. Throws vo::Error when this program has no such option.
Peer make_contestant(const EdvoRow& row) {
  return edvo_peer(row.name, options_of(row.preset, row.assignments));
}

void add(LineUp& result, const EdvoRow& row) {
  try {
    result.peers.push_back(make_contestant(row));
  } catch (const vo::Error& error) {
    result.absent.push_back({row.name, error.what()});
  }
}

void add(LineUp& result, OpencvOdometry kind) {
  if (auto peer = opencv_peer(kind)) {
    result.peers.push_back(*std::move(peer));
  } else {
    result.absent.push_back({std::string(vo::to_string(kind)),
                             "not built in: OpenCV's rgbd module (libopencv-contrib-dev) was not "
                             "there when edvo was built"});
  }
}

}  // namespace

Peer edvo_peer(const std::string& name, const vo::TrackerOptions& options) {
  return {name, [options](const vo::PinholeCamera& camera) {
            const auto odometry = std::make_shared<vo::RgbdOdometry>(camera, options);
            return [odometry, threads = options.align.threads](const vo::RgbdFrame& frame) {
              const OpencvThreads limit(threads);
              return track_frame(*odometry, frame);
            };
          }};
}

vo::TrackerOptions default_with(
    const std::vector<std::pair<std::string, std::string>>& assignments) {
  return options_of(vo::TrackerPreset::best_measured, assignments);
}

std::vector<std::string> peer_names() {
  std::vector<std::string> names;
  for (const EdvoRow& row : edvo_rows()) {
    if (names.empty() || names.back() != row.peer) {
      names.push_back(row.peer);
    }
  }
  names.emplace_back(kMono);
  for (const auto& [kind, name] : enum_names(OpencvOdometry{})) {
    names.emplace_back(name);
  }
  return names;
}

LineUp line_up(const std::vector<std::string>& peers) {
  const auto is_asked_for = [&](const std::string& peer) {
    return std::find(peers.begin(), peers.end(), peer) != peers.end();
  };
  LineUp result;
  for (const EdvoRow& row : edvo_rows()) {
    if (is_asked_for(row.peer)) {
      add(result, row);
    }
  }
  if (is_asked_for(kMono)) {
    result.peers.push_back(mono_peer());
  }
  for (const auto& [kind, name] : enum_names(OpencvOdometry{})) {
    if (is_asked_for(name)) {
      add(result, kind);
    }
  }
  return result;
}

}  // namespace tools
