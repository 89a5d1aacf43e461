#include "tools/cli/trajectory_arguments.h"

#include <algorithm>
#include <string_view>

#include "tools/cli/options.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

void add_trajectory_options(CLI::App& command, TrajectoryArguments& arguments,
                            const std::string& of_each) {
  command.add_option("--format", arguments.format,
                     "of the trajectories, where it is not recognised: " + trajectory_formats() +
                         (of_each.empty() ? "" : "; two names, a,b, are of " + of_each));
  command.add_option("--times", arguments.times,
                     "list of the stamps of trajectories without (KITTI, COLMAP): a stamp a line, "
                     "or a stamp and a file");
}

vo::TrajectoryReading chosen_reading(const TrajectoryArguments& arguments, std::size_t index,
                                     std::size_t count) {
  vo::TrajectoryReading reading{.format = {}, .times = arguments.times};
  if (arguments.format.empty()) {
    return reading;
  }
  const std::vector<std::string> names = split_at_commas(arguments.format);
  if (names.size() != 1 && names.size() != count) {
    vo::fail_as(vo::ErrorKind::usage, "--format ", arguments.format, ": expected one name",
                count > 1 ? vo::concat(", or ", count, " with commas between") : "", ", got ",
                names.size());
  }
  check_usage([&] {
    try {
      reading.format =
          vo::parse_enum<vo::TrajectoryFormat>(names.size() == 1 ? names[0] : names[index]);
    } catch (const vo::Error& error) {
      vo::fail("--format: ", error.what());
    }
  });
  return reading;
}

void require_times_used(const std::string& times,
                        const std::vector<vo::TrajectoryFormat>& formats) {
  const bool is_used = std::any_of(formats.begin(), formats.end(), [](vo::TrajectoryFormat format) {
    return format == vo::TrajectoryFormat::kitti || format == vo::TrajectoryFormat::colmap;
  });
  if (!times.empty() && !is_used) {
    vo::fail_as(vo::ErrorKind::usage, "--times: expected a trajectory without stamps (kitti, ",
                "colmap), got one in the format ", vo::to_string(formats.at(0)));
  }
}

std::string trajectory_formats() {
  std::string text;
  for (const std::string_view name : vo::names_of<vo::TrajectoryFormat>()) {
    text += (text.empty() ? "" : " | ") + std::string(name);
  }
  return text;
}

}  // namespace tools
