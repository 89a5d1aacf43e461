#include "tools/cluster_simulation/shared_file_system.h"

namespace tools {
namespace {

/// Returns the part of what is asked for that is given; all where there is no limit.
double granted(double limit, double asked) {
  return limit > 0 && asked > limit ? limit / asked : 1;
}

}  // namespace

SharedFileSystem::SharedFileSystem(const ClusterOptions& options)
    : bandwidth_(options.bandwidth_mb_s), files_per_s_(options.files_per_s) {
  const double frame_s = (options.frame_s + options.write_s) / options.task_processors;
  if (bandwidth_ > 0) {
    scene_mb_per_s_ = options.scene_s > 0 ? options.scene_mb / options.scene_s : 0;
    frame_mb_per_s_ = options.frame_mb / frame_s;
  }
  if (files_per_s_ > 0) {
    frame_files_per_s_ = options.frame_files / frame_s;
  }
}

void SharedFileSystem::use(std::size_t loading, std::size_t rendering) {
  const auto readers = static_cast<double>(loading);
  const auto writers = static_cast<double>(rendering);
  const double bytes = granted(bandwidth_, readers * scene_mb_per_s_ + writers * frame_mb_per_s_);
  const double files = granted(files_per_s_, writers * frame_files_per_s_);
  speed_ = bytes < files ? bytes : files;
  limit_ = speed_ == 1     ? FileLimit::none
           : bytes < files ? FileLimit::bandwidth
                           : FileLimit::metadata;
}

}  // namespace tools
