#pragma once

#include <string>
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

/// Compares edge pixels, as many random pixels and all pixels over the share of them that is kept
/// (paper, Figure 8).
StudyReport study_points(const Clip& clip, const StudySettings& settings,
                         const vo::Progress& progress);

/// Compares edge detectors, frame to frame and with keyframes (paper, Table 1).
StudyReport study_detectors(const Clip& clip, const StudySettings& settings,
                            const vo::Progress& progress);

/// Compares the residuals of all pixels before and after aligning edges only, up to five frames
/// apart (paper, Figure 4).
StudyReport study_residuals(const Clip& clip, const StudySettings& settings,
                            const vo::Progress& progress);

/// Measures convergence from identity against the number of pyramid levels (paper, Figure 3).
StudyReport study_levels(const Clip& clip, const StudySettings& settings,
                         const vo::Progress& progress);

/// Measures the time of an alignment against its number of points.
StudyReport study_time(const Clip& clip, const StudySettings& settings,
                       const vo::Progress& progress);

/// Compares depth map options of monocular odometry, with tracking and mapping in the loop.
StudyReport study_mono(const Clip& clip, const StudySettings& settings,
                       const vo::Progress& progress);

/// Measures accuracy and convergence of alignment variants on a clip made by `pose_pairs`.
StudyReport study_pairs(const Clip& clip, const StudySettings& settings,
                        const vo::Progress& progress);

std::string as_markdown(const StudyReport& report, const std::string& command);
std::string as_text(const StudyReport& report);
nlohmann::ordered_json as_json(const StudyReport& report);

}  // namespace tools
