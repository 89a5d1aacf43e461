#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "tools/plot/table.h"
#include "tools/scenario/scenario.h"
#include "tools/studies/clip.h"
#include "vo/core/progress.h"
#include "vo/files/result_files.h"
#include "vo/odometry/mono_options.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

/// One configuration of the tracker that a study compares with others.
struct Variant {
  std::string name;
  Assignments changes;  ///< tracker options as for `edvo track --set`
};

struct StudySettings {
  vo::TrackerPreset preset = vo::TrackerPreset::paper;
  Assignments assignments;      ///< option assignments of the user
  int seeds = 5;                ///< repetitions with different random seeds
  double max_error = 0.005;     ///< greatest error of an alignment that counts as converged, m
  double max_error_deg = 0.15;  ///< greatest error of an alignment that counts as converged, deg

  void validate() const;          ///< throws vo::Error on an invalid setting
  std::string described() const;  ///< for example "preset paper with align.loss=none"

  bool accepts(const PoseError& error) const;  ///< whether this error counts as converged

  /// Returns the preset's options overridden by the study's fixed ones, the user's and the varied
  /// ones.
  vo::TrackerOptions options(const Assignments& held, const Assignments& varied) const;

  /// Returns the options of `study_mono`, bootstrapped from the first depth image, overridden by
  /// the user's assignments and then by the varied ones.
  vo::MonoOptions mono_options(const Assignments& varied) const;
};

/// The results of a study. Columns whose names contain `ms` are times and differ from run to run.
struct StudyReport {
  std::string name;  ///< stem of the output files' names
  std::string title;
  std::string method;  ///< one paragraph on how the study was done
  Table table;
  std::vector<std::string> findings;  ///< one sentence each, with numbers
  std::string plot;                   ///< the study's plot as SVG
  std::vector<vo::NamedBytes> more;   ///< further output files
};

using Study = StudyReport(const Clip& clip, const StudySettings& settings,
                          const vo::Progress& progress);

/// Compares edge pixels, as many random pixels and all pixels over the share of them that is kept
/// (paper, Figure 8).
Study study_points;

/// Compares edge detectors, frame to frame and with keyframes (paper, Table 1).
Study study_detectors;

/// Compares the residuals of all pixels before and after aligning edges only, up to five frames
/// apart (paper, Figure 4).
Study study_residuals;

/// Measures convergence from identity against the number of pyramid levels (paper, Figure 3).
Study study_levels;

/// Measures the time of an alignment against its number of points.
Study study_time;

/// Compares depth map options of monocular odometry, with tracking and mapping in the loop.
Study study_mono;

/// Measures accuracy and convergence of alignment variants on a clip made by `pose_pairs`.
Study study_pairs;

/// Tracks the clip as it was recorded and altered: turned, reversed, with faults (alterations.h).
Study study_stress;

/// The studies by name.
inline constexpr std::array kStudies{
    std::pair{"points", &study_points},       std::pair{"detectors", &study_detectors},
    std::pair{"residuals", &study_residuals}, std::pair{"levels", &study_levels},
    std::pair{"time", &study_time},           std::pair{"mono", &study_mono},
    std::pair{"pairs", &study_pairs},         std::pair{"stress", &study_stress}};

/// Returns the files of a study: table, plot, text and what more there is. `command` is the command
/// that repeats the study.
std::vector<vo::NamedBytes> study_files(const StudyReport& report, const std::string& command);

std::string as_text(const StudyReport& report);
nlohmann::ordered_json as_json(const StudyReport& report);

}  // namespace tools
