#include "vo/odometry/track_mono.h"

#include <iostream>

#include <nlohmann/json.hpp>

#include "tools/cli/exit_code.h"
#include "tools/cli/progress_bar.h"
#include "tools/commands/track_arguments.h"
#include "tools/report/report.h"
#include "vo/core/error.h"
#include "vo/core/version.h"
#include "vo/dataset/trajectory_file.h"
#include "vo/files/output.h"

namespace tools {
namespace {

vo::MonoOptions chosen_mono_options(const TrackArguments& arguments) {
  vo::MonoOptions options = vo::mono_options();
  std::vector<vo::Field> fields = vo::fields_of(options);
  apply_arguments(arguments, fields);
  check_usage([&] {
    if (!arguments.bootstrap.empty()) {
      options.bootstrap = vo::parse_enum<vo::MonoBootstrap>(arguments.bootstrap);
    }
    options.validate();
  });
  return options;
}

/// Returns the median mapping time over the frames in which the map was observed, ms.
double mapping_ms(const vo::MonoSequenceResult& result) {
  std::vector<double> times;
  for (const vo::StageTimes& time : result.times) {
    if (time.mapping_ms > 0) {
      times.push_back(time.mapping_ms);
    }
  }
  return vo::percentile(times, 0.5);
}

void print(const TrackArguments& arguments, vo::MonoOptions options,
           const vo::MonoSequenceResult& result) {
  std::ostream& out = vo::is_stream(arguments.out) ? std::cerr : std::cout;
  const vo::TimeSummary times = vo::summarize(result.times);
  if (arguments.common.json) {
    out << nlohmann::ordered_json{{"edvo", vo::version()},
                                  {"sequence", arguments.sequence},
                                  {"estimate", arguments.out},
                                  {"mode", "mono"},
                                  {"frames", result.frames.size()},
                                  {"tracked_fraction", result.tracked_fraction()},
                                  {"keyframes", result.keyframes()},
                                  {"ms_per_frame", time_json(times)},
                                  {"mapping_ms", mapping_ms(result)},
                                  {"options", fields_json(vo::fields_of(options))}}
               .dump(2)
        << "\n";
    return;
  }
  out << arguments.out << ": " << result.trajectory.size() << " of " << result.frames.size()
      << " frames tracked, " << result.keyframes() << " keyframes, " << times.median_ms
      << " ms per frame (median; pyramid " << times.pyramid_ms << ", edges " << times.edges_ms
      << ", alignment " << times.alignment_ms << ", mapping " << mapping_ms(result) << ")\n";
  if (options.bootstrap != vo::MonoBootstrap::rgbd &&
      options.bootstrap != vo::MonoBootstrap::file) {
    out << "the scale is arbitrary: evaluate with --align sim3\n";
  }
}

}  // namespace

std::string describe_mono_fields() {
  vo::MonoOptions options = vo::mono_options();
  return describe_fields(vo::fields_of(options));
}

int track_mono(const TrackArguments& arguments, const std::optional<vo::RgbdCamera>& camera) {
  vo::require(arguments.debug_images == 0,
              "track: --debug-images is for --mode rgbd; "
              "`edvo depth --track` draws monocular maps");
  vo::MonoOptions options = chosen_mono_options(arguments);
  const vo::MonoInput input{arguments.sequence, camera, arguments.max_time_difference,
                            arguments.depth_file};
  ProgressBar bar("tracking", arguments.common.verbosity());
  const vo::MonoSequenceResult result = vo::track_mono_sequence(input, options, {}, bar.callback());
  vo::write_file(arguments.out, vo::format_trajectory(result.trajectory),
                 arguments.common.existing());
  write_config(arguments, vo::fields_of(options));
  if (!arguments.frame_log.empty()) {
    vo::write_file(arguments.frame_log, vo::format_mono_log(result.frames),
                   arguments.common.existing());
  }
  print(arguments, options, result);
  return result.tracked_fraction() < 1 ? exit_code::kTrackingLost : exit_code::kOk;
}

}  // namespace tools
