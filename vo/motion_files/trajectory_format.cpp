#include "vo/motion_files/trajectory_format.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/motion_files/timestamp.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

constexpr std::size_t kTumValues = 8;
constexpr std::size_t kKittiValues = 12;
constexpr std::size_t kColmapNumbers = 9;

bool is_number(std::string_view text) {
  try {
    parse_real(text);
    return true;
  } catch (const Error&) {
    return false;
  }
}

bool is_whole(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](char c) { return (c >= '0' && c <= '9') || c == '-'; });
}

/// Returns how many fields from the first are numbers.
std::size_t leading_numbers(const TextLine& line) {
  return static_cast<std::size_t>(
      std::find_if_not(line.fields.begin(), line.fields.end(), is_number) - line.fields.begin());
}

bool has_comma_behind_first(const TextLine& line) {
  const std::size_t end = line.text.find_first_of(" \t,", line.text.find(line.fields[0]));
  return end != std::string_view::npos && line.text[end] == ',';
}

}  // namespace

bool begins_as_euroc(const TextLine& line) {
  return is_whole(line.fields.at(0)) && has_comma_behind_first(line);
}

TrajectoryFormat recognise_trajectory(const TextFile& file) {
  const TextLine line = file.first_line();
  require(!line.fields.empty(), file.path().string(), ": holds no poses");
  const std::size_t count = line.fields.size();
  const std::size_t numbers = leading_numbers(line);
  if (numbers == kColmapNumbers && count > kColmapNumbers && is_whole(line.fields[0])) {
    return TrajectoryFormat::colmap;
  }
  if (count == kKittiValues && numbers == kKittiValues) {
    return TrajectoryFormat::kitti;
  }
  if (count >= kTumValues && begins_as_euroc(line)) {
    return TrajectoryFormat::euroc;
  }
  require(count == kTumValues, line.place(),
          ": expected the 8 values of a pose as TUM writes it (timestamp tx ty tz qx qy qz qw), 8 "
          "or more behind commas (EuRoC), 12 (KITTI), or 9 and a name (COLMAP's images.txt), got ",
          count);
  const bool is_in_seconds = numbers == 0 || std::abs(parse_real(line.fields[0])) <= kMaxTimestamp;
  return is_in_seconds ? TrajectoryFormat::tum : TrajectoryFormat::orb_slam;
}

}  // namespace vo
