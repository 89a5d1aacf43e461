#include "tools/bench/race.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include <opencv2/core/utility.hpp>

#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::size_t kBlock = 10;  // frames; long enough to warm the caches again

/// The state of all peers in one pass over the sequence.
class Heat {
 public:
  Heat(const Frames& input, const std::vector<Peer>& peers) : input_(input) {
    for (const Peer& peer : peers) {
      trackers_.push_back(peer.start(input.camera));
    }
    samples_.resize(peers.size());
  }

  void run_block(std::size_t peer, std::size_t first, const std::function<void()>& step) {
    const std::size_t end = std::min(first + kBlock, input_.frames.size());
    for (std::size_t i = first; i < end; ++i) {
      samples_[peer].push_back(trackers_[peer](input_.frames[i]));
      step();
    }
  }

  std::vector<FrameSample> take_samples(std::size_t peer) { return std::move(samples_[peer]); }

 private:
  const Frames& input_;
  std::vector<FrameTracker> trackers_;
  std::vector<std::vector<FrameSample>> samples_;
};

}  // namespace

void RaceOptions::validate() const {
  vo::require(warm_up >= 1, "warm-up: expected at least 1 frame, got ", warm_up);
  vo::require(repeats >= 1, "--repeat: expected at least 1, got ", repeats);
}

std::vector<RaceResult> race(const Frames& input, const std::vector<Peer>& peers,
                             const RaceOptions& options, const vo::Progress& progress) {
  options.validate();
  vo::require(input.frames.size() > static_cast<std::size_t>(options.warm_up),
              "bench: expected more frames than the ", options.warm_up, " of the warm-up, got ",
              input.frames.size());
  cv::setNumThreads(1);
  std::vector<RaceResult> results;
  for (const Peer& peer : peers) {
    results.push_back({.name = peer.name});
  }
  const std::size_t count = peers.size();
  const auto repeats = static_cast<std::size_t>(options.repeats);
  std::size_t done = 0;
  const auto step = [&] { progress(++done, repeats * count * input.frames.size()); };
  for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
    Heat heat(input, peers);
    for (std::size_t first = 0; first < input.frames.size(); first += kBlock) {
      for (std::size_t turn = 0; turn < count; ++turn) {
        heat.run_block((turn + first / kBlock + repeat) % count, first, step);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      results[i].samples.push_back(heat.take_samples(i));
    }
  }
  return results;
}

vo::Trajectory trajectory(const RaceResult& result, const Frames& input) {
  vo::Trajectory poses;
  const std::vector<FrameSample>& samples = result.samples.front();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].T_world_camera) {
      poses.push_back({input.frames[i].timestamp, *samples[i].T_world_camera});
    }
  }
  return poses;
}

}  // namespace tools
