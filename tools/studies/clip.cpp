#include "tools/studies/clip.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "tools/plot/statistics.h"
#include "tools/sequence_cache/sequence_cache.h"
#include "vo/core/error.h"
#include "vo/core/processor_time.h"
#include "vo/core/stopwatch.h"
#include "vo/evaluation/evaluate.h"

namespace tools {
namespace {

double seconds(const vo::Trajectory& trajectory) {
  return trajectory.back().timestamp - trajectory.front().timestamp;
}

}  // namespace

ClipErrors errors_of(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  constexpr double kShareOfShortClip = 0.5;
  constexpr std::size_t kMinPoses = 3;
  if (estimate.size() < kMinPoses) {
    return {};
  }
  const double interval = std::min(1.0, kShareOfShortClip * seconds(estimate));
  const vo::TrajectoryErrors errors =
      vo::evaluate(truth, estimate, {.interval = {.length = interval}});
  return {.rpe_mm = kMmPerM * errors.rpe.translation.rmse,
          .rpe_deg = errors.rpe.rotation_deg.rmse,
          .ate_mm = kMmPerM * errors.ate.rmse,
          .worst_mm = kMmPerM * errors.ate.max};
}

Clip load_clip(const vo::SequenceReader& sequence, const std::string& name, std::size_t max_frames,
               const vo::Progress& progress) {
  vo::require(!sequence.ground_truth().empty(), name,
              ": has no groundtruth.txt, which the errors are measured against");
  Clip clip{.name = name, .camera = sequence.camera().pinhole, .truth = sequence.ground_truth()};
  const std::size_t count =
      max_frames == 0 ? sequence.size() : std::min(max_frames, sequence.size());
  for (std::size_t i = 0; i < count; ++i) {
    clip.frames.push_back(sequence.read(i));
    progress(i + 1, count);
  }
  return clip;
}

Clip load_clip(const Scenario& scenario, const std::filesystem::path& cache,
               const RunProgress& progress) {
  const CachedSequence cached = cached_sequence(cache, render_job(scenario), progress.render);
  return load_clip(vo::SequenceReader(cached.folder), scenario.name, 0, progress.track);
}

ClipScore score(const Clip& clip, const vo::TrackerOptions& options) {
  vo::RgbdOdometry odometry(clip.camera, options);
  std::vector<double> times_ms;
  double points = 0;
  double aligned = 0;
  for (const vo::RgbdFrame& frame : clip.frames) {
    const vo::CpuStopwatch watch;
    const vo::TrackingResult result = odometry.track(frame);
    times_ms.push_back(watch.elapsed_ms());
    if (result.status == vo::TrackingStatus::tracked) {
      points += static_cast<double>(result.alignment.points);
      ++aligned;
    }
  }
  ClipScore score{errors_of(clip.truth, odometry.trajectory())};
  score.points = points / aligned;
  score.ms_per_frame = median(times_ms);
  score.tracked_percent = 100 * static_cast<double>(odometry.trajectory().size()) /
                          static_cast<double>(clip.frames.size());
  return score;
}

std::vector<FramePair> pairs_apart(const Clip& clip, std::size_t distance, std::size_t count) {
  std::vector<FramePair> pairs;
  if (clip.frames.size() <= distance) {
    return pairs;
  }
  const std::size_t starts = clip.frames.size() - distance;
  const std::size_t wanted = std::min(count, starts);
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t ref = i * starts / wanted;
    const auto T_world_ref = vo::pose_at(clip.truth, clip.frames[ref].timestamp);
    const auto T_world_cur = vo::pose_at(clip.truth, clip.frames[ref + distance].timestamp);
    if (T_world_ref && T_world_cur) {
      pairs.push_back({ref, ref + distance, T_world_cur->inverse() * *T_world_ref});
    }
  }
  return pairs;
}

vo::FramePyramid pyramid_of(const vo::RgbdFrame& frame, const vo::PinholeCamera& camera,
                            const vo::TrackerOptions& options) {
  vo::FramePyramid pyramid = vo::build_pyramid(
      frame, options.lens == vo::LensModel::ignore ? camera.without_distortion() : camera,
      options.pyramid);
  vo::add_edges(pyramid, options.edges);
  return pyramid;
}

PoseError pose_error(const vo::SE3& T_true, const vo::SE3& T_estimated) {
  const vo::SE3 T_error = T_true.inverse() * T_estimated;
  return {kMmPerM * T_error.translation().norm(), T_error.angle() * 180 / std::numbers::pi};
}

void PairScores::add(const PoseError& error, const vo::AlignResult& alignment) {
  mm.push_back(error.mm);
  deg.push_back(error.deg);
  points.push_back(static_cast<double>(alignment.points));
  iterations.push_back(alignment.iterations);
}

double mean_flow_px(const vo::DepthImage& depth, const vo::PinholeCamera& camera,
                    const vo::SE3& T_cur_ref, int step) {
  double sum = 0;
  double count = 0;
  for (int v = 0; v < depth.rows; v += step) {
    for (int u = 0; u < depth.cols; u += step) {
      if (!vo::has_depth(depth(v, u))) {
        continue;
      }
      const Eigen::Vector2d pixel(u, v);
      const Eigen::Vector3d p_cur = T_cur_ref * camera.unproject(pixel, depth(v, u));
      if (p_cur.z() > 0) {
        sum += (camera.project(p_cur) - pixel).norm();
        ++count;
      }
    }
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace tools
