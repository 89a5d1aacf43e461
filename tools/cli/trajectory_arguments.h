#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "vo/motion_files/trajectory_file.h"

namespace tools {

/// Command-line options of the trajectories that a command reads.
struct TrajectoryArguments {
  std::string format;  ///< one name for all of them, or one for each with commas between
  std::string times;   ///< list of stamps for trajectories without; empty without one
};

/// Adds `--format` and `--times`; `of_each` says what names with commas between are of.
void add_trajectory_options(CLI::App& command, TrajectoryArguments& arguments,
                            const std::string& of_each = "");

/// Returns how the trajectory of this index, of `count`, is to be read. Throws vo::Error of kind
/// usage.
vo::TrajectoryReading chosen_reading(const TrajectoryArguments& arguments, std::size_t index = 0,
                                     std::size_t count = 1);

/// Throws vo::Error of kind usage if a list of stamps was given and all trajectories, which have
/// these formats, have stamps of their own.
void require_times_used(const std::string& times, const std::vector<vo::TrajectoryFormat>& formats);

/// Returns the names of the formats for help: `tum | euroc | ...`.
std::string trajectory_formats();

}  // namespace tools
