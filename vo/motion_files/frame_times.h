#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vo {

/// The stamps of frames for trajectories that have none. A list has a line for each frame, with
/// its stamp in s alone, as KITTI's times.txt, or with the frame's file behind it, as TUM's rgb.txt
/// and EuRoC's data.csv, where a stamp that is the file's name without its ending is in ns.
class FrameTimes {
 public:
  /// Reads a list. Throws Error naming file and line.
  explicit FrameTimes(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  std::size_t size() const { return timestamps_.size(); }
  double at(std::size_t frame) const { return timestamps_.at(frame); }  ///< s
  bool has_names() const { return !frames_.empty(); }

  /// Returns the stamp, s, of the frame with this file; folders before the name do not count.
  std::optional<double> of_file(const std::string& name) const;

 private:
  std::filesystem::path path_;
  std::vector<double> timestamps_;
  std::map<std::string, std::size_t> frames_;  ///< by the file's name without folders
};

}  // namespace vo
