#include "vo/motion_files/colmap_images.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/numbered_files.h"
#include "vo/motion_files/pose_collector.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {
namespace {

constexpr std::size_t kNumbers = 9;            // before an image's name
constexpr std::size_t kNanosecondDigits = 19;  // of stamps since 2001

double stamp_in_name(const TextLine& line, const std::string& name, std::string_view number) {
  if (number.find('.') != std::string_view::npos) {
    return parse_real(number);
  }
  if (number.size() == kNanosecondDigits) {
    return kNanosecond * parse_real(number);
  }
  fail(line.place(),
       ": expected a name that ends with a stamp, in s with a decimal point or in ns "
       "with ",
       kNanosecondDigits, " digits, got ", name,
       "; --times LIST gives the stamps of files or frame numbers");
}

double stamp_in_list(const TextLine& line, const std::string& name, std::string_view number,
                     const FrameTimes& times) {
  if (times.has_names()) {
    const std::optional<double> stamp = times.of_file(name);
    require(stamp.has_value(), line.place(), ": expected a file that ", times.path().string(),
            " lists, got ", name);
    return *stamp;
  }
  const bool is_frame = !number.empty() && number.size() < kNanosecondDigits &&
                        number.find('.') == std::string_view::npos;
  require(is_frame, line.place(), ": expected a name that ends with the number of a frame, got ",
          name);
  const auto frame = static_cast<std::size_t>(parse_integer(number));
  require(frame < times.size(), line.place(), ": is frame ", frame,
          " (from 0), expected one of the ", times.size(), " of ", times.path().string());
  return times.at(frame);
}

/// Returns the line from its tenth field on, without blanks at its ends: names may have blanks.
std::string name_of(const TextLine& line) {
  const auto begin = static_cast<std::size_t>(line.fields[kNumbers].data() - line.text.data());
  const std::string_view name = line.text.substr(begin);
  return std::string(name.substr(0, name.find_last_not_of(" \t\r") + 1));
}

StampedPose parse_image(const TextLine& line, const FrameTimes* times) {
  require(line.fields.size() > kNumbers, line.place(),
          ": expected an image (IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME), got ",
          line.fields.size(), " values");
  std::array<double, kNumbers> v{};
  for (std::size_t i = 0; i < kNumbers; ++i) {
    v.at(i) = parse_number(line, i);
  }
  const SE3 T_camera_world =
      checked_pose(line.place(), {v[1], v[2], v[3], v[4]}, {v[5], v[6], v[7]});
  const std::string name = name_of(line);
  const std::string stem = std::filesystem::path(name).stem();
  const std::string_view number = number_at_end(stem);
  const double timestamp = times == nullptr ? stamp_in_name(line, name, number)
                                            : stamp_in_list(line, name, number, *times);
  return {checked_timestamp(line, timestamp), T_camera_world.inverse()};
}

/// Throws Error unless a line has points: three numbers each, or nothing.
void require_points(const TextLine& line) {
  const bool is_whole = line.fields.size() % 3 == 0;
  require(
      is_whole, line.place(),
      ": expected the points of the image before it (X Y POINT3D_ID ...) or an empty line, got ",
      line.fields.size(), " values");
  if (!line.fields.empty()) {
    parse_number(line, line.fields.size() - 1);
  }
}

}  // namespace

Trajectory read_colmap_images(const TextFile& file, const FrameTimes* times,
                              std::vector<std::string>& notes) {
  PoseCollector poses(file.path(), PoseCollector::Order::none);
  poses.reserve(file.line_count() / 2);
  bool is_points = false;
  file.for_each_whole_line([&](const TextLine& line) {
    if (line.text.starts_with('#') || (!is_points && line.fields.empty())) {
      return;
    }
    if (is_points) {
      require_points(line);
    } else {
      poses.add(parse_image(line, times), line);
    }
    is_points = !is_points;
  });
  return poses.finish(notes);
}

}  // namespace vo
