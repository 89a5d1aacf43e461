#pragma once

#include <cstddef>

#include "tools/cluster_simulation/cluster_options.h"

namespace tools {

/// What a file system that is used at its limit holds tasks up by.
enum class FileLimit { none, bandwidth, metadata };

/// The file system that all nodes share. While its users ask for more than it gives, all of them
/// go on at the same fraction of their speed; so a clock that runs at this fraction tells when each
/// of them ends, however many begin and end in between.
class SharedFileSystem {
 public:
  explicit SharedFileSystem(const ClusterOptions& options);

  bool slows_loading() const { return scene_mb_per_s_ > 0; }
  bool slows_rendering() const { return frame_mb_per_s_ > 0 || frame_files_per_s_ > 0; }

  /// Sets how many tasks load their scene and how many render.
  void use(std::size_t loading, std::size_t rendering);

  double speed() const { return speed_; }  ///< fraction of full speed, (0, 1]
  FileLimit limit() const { return limit_; }

 private:
  double bandwidth_;
  double files_per_s_;
  double scene_mb_per_s_ = 0;     ///< what a task asks for at full speed while it loads, MB/s
  double frame_mb_per_s_ = 0;     ///< the same while it renders, MB/s
  double frame_files_per_s_ = 0;  ///< the same while it renders, files per s
  double speed_ = 1;
  FileLimit limit_ = FileLimit::none;
};

}  // namespace tools
