#include "vo/motion_files/pose_collector.h"

#include <algorithm>
#include <utility>

namespace vo {

PoseCollector::PoseCollector(std::filesystem::path path, Order order)
    : path_(std::move(path)), order_(order) {}

double PoseCollector::take(const StampedPose& pose) {
  const double back = poses_.empty() ? 0 : latest_ - pose.timestamp;
  disordered_ += back > 0 ? 1 : 0;
  most_disorder_ = std::max(most_disorder_, back);
  latest_ = poses_.empty() ? pose.timestamp : std::max(latest_, pose.timestamp);
  poses_.push_back(pose);
  return back;
}

Trajectory PoseCollector::finish(std::vector<std::string>& notes) {
  require(!poses_.empty(), path_.string(), ": holds no poses");
  if (disordered_ > 0) {
    std::stable_sort(poses_.begin(), poses_.end(),
                     [](const auto& a, const auto& b) { return a.timestamp < b.timestamp; });
  }
  if (disordered_ > 0 && order_ == Order::of_time) {
    notes.push_back(concat(path_.string(), ": ", disordered_, " of ", poses_.size(),
                           " poses came after later ones, by up to ", most_disorder_,
                           " s; they were sorted"));
  }
  const std::size_t all = poses_.size();
  poses_.erase(std::unique(poses_.begin(), poses_.end(),
                           [](const auto& a, const auto& b) { return a.timestamp == b.timestamp; }),
               poses_.end());
  if (poses_.size() < all) {
    notes.push_back(concat(path_.string(), ": ", all - poses_.size(), " of ", all,
                           " poses have the stamp of another; the first of each stamp counts"));
  }
  return std::move(poses_);
}

}  // namespace vo
