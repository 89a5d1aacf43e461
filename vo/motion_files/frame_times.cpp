#include "vo/motion_files/frame_times.h"

#include "vo/core/error.h"
#include "vo/motion_files/timestamp.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

/// Returns the stamp of a line, s, which EuRoC's lists have in ns.
double stamp_of(const TextLine& line) {
  const bool is_euroc = line.fields.size() > 1 &&
                        line.fields[0].find('.') == std::string_view::npos &&
                        std::filesystem::path(line.fields[1]).stem() == line.fields[0];
  return is_euroc ? parse_nanoseconds(line, 0) : parse_timestamp(line, 0);
}

}  // namespace

FrameTimes::FrameTimes(const std::filesystem::path& path) : path_(path) {
  TextFile(path).for_each_line([&](const TextLine& line) {
    if (line.fields.size() > 1) {
      const std::string name = std::filesystem::path(line.fields[1]).filename();
      require(frames_.emplace(name, timestamps_.size()).second, line.place(),
              ": expected files of different names, got ", name, " again");
    }
    timestamps_.push_back(stamp_of(line));
    require(frames_.empty() || frames_.size() == timestamps_.size(), line.place(),
            ": expected a stamp and a file as in the lines before it, got ", line.fields.size(),
            " values");
  });
  require(!timestamps_.empty(), path.string(), ": holds no stamps");
}

std::optional<double> FrameTimes::of_file(const std::string& name) const {
  const auto found = frames_.find(std::filesystem::path(name).filename());
  return found == frames_.end() ? std::nullopt : std::optional(timestamps_[found->second]);
}

}  // namespace vo
