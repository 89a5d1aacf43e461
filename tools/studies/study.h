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

/// One of the things that a study compares.
struct Variant {
  std::string name;
  Assignments changes;  ///< of the tracker's options, as `edvo track --set` takes them
};

struct StudySettings {
  vo::TrackerPreset preset = vo::TrackerPreset::paper;
  Assignments assignments;      ///< what the user set
  int seeds = 5;                ///< repetitions of what is random
  double max_error = 0.005;     ///< m, of an alignment that converged
  double max_error_deg = 0.15;  ///< deg, of an alignment that converged

  void validate() const;          ///< throws vo::Error
  std::string described() const;  ///< "preset paper with align.loss=none"

  bool accepts(const PoseError& error) const;  ///< an alignment with this error converged

  /// The preset, then what the study holds fixed, then what the user set, then what it varies.
  vo::TrackerOptions options(const Assignments& held, const Assignments& varied) const;

  /// Of `study_mono`, started from the first depth image: what the user set, then what is varied.
  vo::MonoOptions mono_options(const Assignments& varied) const;
};

/// What a study found. Where it measures time, two runs differ in the columns that say `ms`.
struct StudyReport {
  std::string name;  ///< of its files
  std::string title;
  std::string method;  ///< one paragraph: what was done
  Table table;
  std::vector<std::string> findings;  ///< one sentence each, with figures
  std::string plot;                   ///< SVG
  std::vector<vo::NamedBytes> more;   ///< further files
};

/// Edges against as many random pixels against all pixels, over the share of them that is kept
/// (paper, Figure 8).
StudyReport study_points(const Clip& clip, const StudySettings& settings,
                         const vo::Progress& progress);

/// Edge detectors, frame to frame and with keyframes (paper, Table 1).
StudyReport study_detectors(const Clip& clip, const StudySettings& settings,
                            const vo::Progress& progress);

/// Residuals of all pixels before and after aligning edges only, up to five frames apart (paper,
/// Figure 4).
StudyReport study_residuals(const Clip& clip, const StudySettings& settings,
                            const vo::Progress& progress);

/// Depth of the pyramid against convergence from identity (paper, Figure 3).
StudyReport study_levels(const Clip& clip, const StudySettings& settings,
                         const vo::Progress& progress);

/// Time of an alignment against its number of points.
StudyReport study_time(const Clip& clip, const StudySettings& settings,
                       const vo::Progress& progress);

/// The ways of keeping a depth map, in the loop with the tracker.
StudyReport study_mono(const Clip& clip, const StudySettings& settings,
                       const vo::Progress& progress);

/// Pairs of a clip made by `pose_pairs`: accuracy and basin of variants of the alignment.
StudyReport study_pairs(const Clip& clip, const StudySettings& settings,
                        const vo::Progress& progress);

std::string as_markdown(const StudyReport& report, const std::string& command);
std::string as_text(const StudyReport& report);
nlohmann::ordered_json as_json(const StudyReport& report);

}  // namespace tools
