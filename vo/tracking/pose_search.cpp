#include "vo/tracking/pose_search.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "vo/residuals/linearize.h"
#include "vo/tracking/image_motion.h"

namespace vo {
namespace {

/// Returns the poses of highest agreement, best first, the earlier of equals; at most `count`.
std::vector<SE3> highest(std::vector<std::pair<double, SE3>> ranked, std::size_t count) {
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<SE3> poses;
  for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) {
    poses.push_back(ranked[i].second);
  }
  return poses;
}

}  // namespace

double coarse_agreement(const Keyframe& keyframe, const FramePyramid& frame,
                        const SE3& T_world_camera) {
  constexpr double kMinOverlap = 0.33;
  const SE3 T_cur_ref = T_world_camera.inverse() * keyframe.T_world_keyframe;
  if (image_motion(*keyframe.points, frame, T_cur_ref).overlap < kMinOverlap) {
    return -1;
  }
  return correlation({keyframe.points->levels.back(), frame.levels.back(), T_cur_ref, {}, {}});
}

SE3 best_guess(const Keyframe& keyframe, const FramePyramid& frame,
               std::initializer_list<SE3> T_world_camera_guesses) {
  SE3 best;
  double highest_agreement = -std::numeric_limits<double>::infinity();
  for (const SE3& guess : T_world_camera_guesses) {
    const double agreement = coarse_agreement(keyframe, frame, guess);
    if (agreement > highest_agreement) {
      highest_agreement = agreement;
      best = guess;
    }
  }
  return best;
}

std::vector<SE3> best_guesses(const Keyframe& keyframe, const FramePyramid& frame,
                              const std::vector<SE3>& T_world_camera_guesses, std::size_t count) {
  std::vector<std::pair<double, SE3>> ranked;
  ranked.reserve(T_world_camera_guesses.size());
  for (const SE3& guess : T_world_camera_guesses) {
    ranked.emplace_back(coarse_agreement(keyframe, frame, guess), guess);
  }
  return highest(std::move(ranked), count);
}

std::vector<SE3> turned_guesses(const SE3& T_world_camera) {
  constexpr double kStep = 4 * std::numbers::pi / 180;
  constexpr int kSteps = 3;
  constexpr int kWidth = 2 * kSteps + 1;
  std::vector<SE3> guesses{T_world_camera};
  for (int i = 0; i < kWidth * kWidth * kWidth; ++i) {
    const Eigen::Vector3i index(i % kWidth, i / kWidth % kWidth, i / (kWidth * kWidth));
    const Eigen::Vector3d steps = (index.array() - kSteps).cast<double>();
    if (!steps.isZero() && steps.norm() <= kSteps + 0.5) {
      Vector6d turn = Vector6d::Zero();
      turn.tail<3>() = kStep * steps;
      guesses.push_back(T_world_camera * SE3::exp(turn));
    }
  }
  return guesses;
}

std::vector<SE3> similar_keyframes(const LocalMap& map, const FramePyramid& frame,
                                   std::size_t count) {
  std::vector<std::pair<double, SE3>> ranked;
  for (const std::shared_ptr<const Keyframe>& keyframe : map.keyframes()) {
    ranked.emplace_back(coarse_agreement(*keyframe, frame, keyframe->T_world_keyframe),
                        keyframe->T_world_keyframe);
  }
  return highest(std::move(ranked), count);
}

bool is_more_credible(const TrackingResult& found, const TrackingResult& best) {
  constexpr double kClearlyBetter = 0.02;  // difference of two correlations
  constexpr double kWorse = 0.05;          // difference of two depth agreements
  if (found.status != TrackingStatus::tracked || best.status != TrackingStatus::tracked) {
    return found.status == TrackingStatus::tracked;
  }
  return found.alignment.correlation > best.alignment.correlation + kClearlyBetter &&
         found.alignment.depth_agreement >= best.alignment.depth_agreement - kWorse;
}

bool is_doubtful(TrackingStatus status, double correlation) {
  constexpr double kDoubtfulCorrelation = 0.8;
  return status == TrackingStatus::lost || correlation < kDoubtfulCorrelation;
}

}  // namespace vo
