#include "vo/evaluation/evaluate.h"

#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/trajectory_arguments.h"
#include "tools/commands/commands.h"
#include "tools/evo_result/evo_result.h"
#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/sequence.h"
#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/videos/video_sequence.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kEvaluateHelp =
    "Compares an estimated trajectory with the truth, each in a format that is read: TUM, EuRoC's\n"
    "ground truth, KITTI's poses, ORB-SLAM3's stamps in ns, COLMAP's images.txt.\n"
    "  ate      absolute error of positions after alignment (evaluate_ate.py, evo_ape), m\n"
    "  rpe      relative error per interval as the TUM benchmark's evaluate_rpe.py --fixed_delta\n"
    "  rpe_evo  the same as evo_rpe --all_pairs and the paper define it; it differs in the\n"
    "           translation's frame and in which poses it pairs\n"
    "Poses are matched by nearest stamp; nothing is interpolated but for --estimate-offset.";

constexpr const char* kEvaluateExamples =
    "Examples:\n"
    "  edvo evaluate groundtruth.txt estimate.txt\n"
    "  edvo evaluate groundtruth.txt estimate.txt --align sim3 --interval 30f --json\n"
    "  edvo evaluate poses/00.txt estimate.txt --times sequences/00/times.txt   # KITTI\n"
    "  edvo evaluate groundtruth.txt sparse/0/images.txt --times rgb.txt --align sim3   # COLMAP\n"
    "  edvo evaluate groundtruth.txt estimate.txt --evo-ape edvo.zip && evo_res edvo.zip orb.zip\n"
    "  edvo evaluate groundtruth.txt estimate.txt --estimate-offset   # are the clocks right?\n"
    "  edvo evaluate sequence/groundtruth.txt e.txt --sequence sequence   # and tracked_fraction";

struct EvaluateArguments {
  CommonOptions common;
  std::string truth;
  std::string estimate;
  TrajectoryArguments reading;
  std::string align = "se3";
  std::string interval = "1s";
  bool interval_is_chosen = false;
  std::string sequence;
  std::string evo_ape;
  bool estimate_offset = false;
  vo::EvaluationOptions options;
};

/// The results that `edvo evaluate` prints.
struct Report {
  std::vector<std::string> notes;  ///< on the trajectories' files
  vo::TrajectoryFormat truth_format = vo::TrajectoryFormat::tum;
  vo::TrajectoryFormat estimate_format = vo::TrajectoryFormat::tum;
  vo::TrajectoryErrors errors;
  double tracked_fraction = -1;  ///< share of frames with a pose; negative if unknown
  bool has_offset = false;
  vo::TimeOffset offset;
};

vo::RpeInterval parse_interval(const std::string& text) {
  try {
    vo::require(text.size() > 1 && (text.back() == 's' || text.back() == 'f'), "no unit");
    const double length = vo::parse_real(std::string_view(text).substr(0, text.size() - 1));
    vo::require(length > 0, "not positive");
    return {length, text.back() == 's' ? vo::IntervalUnit::seconds : vo::IntervalUnit::frames};
  } catch (const vo::Error&) {
    vo::fail_as(vo::ErrorKind::usage, "--interval ", text,
                ": expected seconds or frames above 0, such as 1s or 30f");
  }
}

Json statistics(const vo::Statistics& s, const std::string& prefix, const std::string& unit) {
  return {{prefix + "rmse_" + unit, s.rmse},
          {prefix + "mean_" + unit, s.mean},
          {prefix + "median_" + unit, s.median},
          {prefix + "max_" + unit, s.max}};
}

Json relative(const vo::RelativeErrors& errors) {
  Json json = statistics(errors.translation, "translation_", "m");
  json.update(statistics(errors.rotation_deg, "rotation_", "deg"));
  json["pairs"] = errors.pairs;
  return json;
}

Json as_json(const EvaluateArguments& arguments, const Report& report) {
  const vo::TrajectoryErrors& errors = report.errors;
  Json json = {{"truth_format", vo::to_string(report.truth_format)},
               {"estimate_format", vo::to_string(report.estimate_format)},
               {"notes", report.notes},
               {"align", arguments.align},
               {"interval", arguments.interval},
               {"ate", statistics(errors.ate, "", "m")},
               {"rpe", relative(errors.rpe)},
               {"rpe_evo", relative(errors.rpe_evo)},
               {"scale", errors.scale},
               {"matched", errors.matched},
               {"matched_fraction", errors.matched_fraction}};
  if (report.tracked_fraction >= 0) {
    json["tracked_fraction"] = report.tracked_fraction;
  }
  if (report.has_offset) {
    const vo::TimeOffset& offset = report.offset;
    json["time_offset"] = {{"ate_offset_s", offset.ate_offset},
                           {"ate_rmse_m", offset.ate_rmse},
                           {"rpe_translation_offset_s", offset.rpe_translation_offset},
                           {"rpe_translation_rmse_m", offset.rpe_translation_rmse},
                           {"rpe_rotation_offset_s", offset.rpe_rotation_offset},
                           {"rpe_rotation_rmse_deg", offset.rpe_rotation_rmse_deg}};
  }
  return json;
}

void print_row(const char* name, const vo::Statistics& s, const char* unit) {
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "%-20s %10.6f %10.6f %10.6f %10.6f  %s\n", name, s.rmse,
                s.mean, s.median, s.max, unit);
  std::cout << line.data();
}

void print_offset(const vo::TimeOffset& offset) {
  std::array<char, 240> text{};
  std::snprintf(text.data(), text.size(),
                "stamps shifted by    %+.4f s give the least ATE, %.6f m\n"
                "                     %+.4f s give the least RPE translation, %.6f m\n"
                "                     %+.4f s give the least RPE rotation, %.6f deg\n",
                offset.ate_offset, offset.ate_rmse, offset.rpe_translation_offset,
                offset.rpe_translation_rmse, offset.rpe_rotation_offset,
                offset.rpe_rotation_rmse_deg);
  std::cout << text.data();
}

void print_table(const EvaluateArguments& arguments, const Report& report, const Colours& colours) {
  const vo::TrajectoryErrors& errors = report.errors;
  const std::string per = "per " + arguments.interval;
  std::array<char, 160> title{};
  std::snprintf(title.data(), title.size(), "%-20s %10s %10s %10s %10s\n", "", "rmse", "mean",
                "median", "max");
  std::cout << title.data();
  print_row("ate", errors.ate, "m");
  print_row("rpe translation", errors.rpe.translation, ("m " + per).c_str());
  print_row("rpe rotation", errors.rpe.rotation_deg, ("deg " + per).c_str());
  print_row("rpe_evo translation", errors.rpe_evo.translation, ("m " + per).c_str());
  print_row("rpe_evo rotation", errors.rpe_evo.rotation_deg, ("deg " + per).c_str());
  std::cout << "intervals            " << errors.rpe.pairs << " (rpe_evo " << errors.rpe_evo.pairs
            << ")\n";
  std::cout << "matched              " << errors.matched << " poses, "
            << 100 * errors.matched_fraction << " % of the estimate's\n"
            << "aligned              " << arguments.align << ", scale " << errors.scale << "\n";
  if (report.tracked_fraction >= 0) {
    std::cout << "tracked              " << 100 * report.tracked_fraction
              << " % of the sequence's frames\n";
  }
  if (report.has_offset) {
    print_offset(report.offset);
  }
  for (const std::string& note : report.notes) {
    std::cout << colours.paint(Tone::caution, "note") << "                 " << note << "\n";
  }
}

/// Reads the trajectory of this index, its notes and format into the report.
vo::Trajectory read(const EvaluateArguments& arguments, std::size_t index, Report& report) {
  vo::TrajectoryFile file =
      vo::read_trajectory_file(index == 0 ? arguments.truth : arguments.estimate,
                               chosen_reading(arguments.reading, index, 2));
  (index == 0 ? report.truth_format : report.estimate_format) = file.format;
  report.notes.insert(report.notes.end(), file.notes.begin(), file.notes.end());
  return std::move(file.trajectory);
}

/// Returns the stamps, s, of the frames of a sequence, whose camera need not be known.
std::vector<double> frame_stamps(const std::string& folder) {
  const std::optional<vo::SequenceFormat> format = vo::known_format(folder);
  if (format == vo::SequenceFormat::video) {
    return vo::video_stamps(folder);
  }
  return format.value_or(vo::SequenceFormat::tum) == vo::SequenceFormat::tum
             ? vo::SequenceReader(folder, vo::RgbdCamera{}).timestamps()
             : vo::open_sequence(folder, *format).timestamps;
}

void evaluate(EvaluateArguments& arguments, const Session& session) {
  arguments.options.alignment = vo::parse_enum<vo::TrajectoryAlignment>(arguments.align);
  arguments.options.interval = parse_interval(arguments.interval);
  if (!arguments.evo_ape.empty()) {
    vo::require_writable(arguments.evo_ape);
  }
  ProgressBar bar("evaluating", arguments.common.verbosity());
  bar.announce();
  Report report;
  const vo::Trajectory truth = read(arguments, 0, report);
  const vo::Trajectory estimate = read(arguments, 1, report);
  require_times_used(arguments.reading.times, {report.truth_format, report.estimate_format});
  report.errors = vo::evaluate(truth, estimate, arguments.options);
  vo::require(report.errors.rpe.pairs > 0 || !arguments.interval_is_chosen, arguments.estimate,
              ": no two of its ", estimate.size(), " poses lie --interval ", arguments.interval,
              " apart, expected a shorter interval or a longer trajectory");
  if (!arguments.sequence.empty()) {
    report.tracked_fraction = vo::tracked_fraction(frame_stamps(arguments.sequence), estimate);
  }
  if (arguments.estimate_offset) {
    report.has_offset = true;
    report.offset = vo::estimate_time_offset(truth, estimate, arguments.options);
  }
  if (!arguments.evo_ape.empty()) {
    vo::write_file(
        arguments.evo_ape,
        encode_evo_ape({truth, estimate, arguments.truth, arguments.estimate}, arguments.options),
        arguments.common.output_policy());
  }
  bar.erase();
  if (arguments.common.json) {
    std::cout << json_text(json_document({"evaluate"}, as_json(arguments, report)));
  } else {
    print_table(arguments, report, session.out);
  }
}

}  // namespace

void add_evaluate_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("evaluate", kEvaluateHelp);
  const auto arguments = std::make_shared<EvaluateArguments>();
  command.footer(kEvaluateExamples);
  command.add_option("TRUTH", arguments->truth, "trajectory")->required();
  command.add_option("ESTIMATE", arguments->estimate, "trajectory")->required();
  add_trajectory_options(command, arguments->reading, "TRUTH and ESTIMATE");
  command.add_option("--align", arguments->align, "none | se3 | sim3 [se3]")
      ->check(is_name_of<vo::TrajectoryAlignment>());
  command.add_option("--interval", arguments->interval, "of the relative error: 1s, 30f, ... [1s]")
      ->each([arguments](const std::string&) { arguments->interval_is_chosen = true; });
  add_time_difference_option(command, arguments->options.max_time_difference, "matched poses");
  command.add_option("--offset", arguments->options.time_offset,
                     "added to the estimate's stamps, s [0]");
  command.add_flag("--estimate-offset", arguments->estimate_offset,
                   "also print the offsets that would make each error least");
  command.add_option("--sequence", arguments->sequence,
                     "the sequence that was tracked, for tracked_fraction");
  command.add_option(
      "--evo-ape", arguments->evo_ape,
      "ZIP with the absolute errors as evo_ape --save_results writes it, for evo_res");
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"TRUTH", "ESTIMATE", "--times"},
                         .read = {"--sequence"},
                         .written = {"--evo-ape"}});
  command.callback([arguments, &session] { evaluate(*arguments, session); });
}

}  // namespace tools
