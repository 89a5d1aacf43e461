#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/datasets/spec.h"
#include "tools/plot/plot.h"

namespace tools {

/// Returns the cells of a row of frames.csv. Throws vo::Error where it has too few or too many.
std::vector<std::string> cells_of_row(std::string_view row);

/// Numbers of frames by a value's range, of which a distribution is drawn.
class ValueCounts {
 public:
  /// Counts from 0 to `most`; greater values count as `most`.
  explicit ValueCounts(double most) : most_(most) {}

  void add(double value);

  /// Returns the share of the values, in percent, that are at most as great as each bin's end.
  std::vector<PlotPoint> distribution() const;

 private:
  static constexpr std::size_t kBins = 200;

  double most_;
  std::array<std::size_t, kBins> counts_{};
  std::size_t total_ = 0;
};

/// What the rows of one sequence's frames say, summed, those of all cameras of a rig.
struct SequenceStatistics {
  std::size_t frames = 0;
  double duration_s = 0;      ///< of the first camera
  double length_m = 0;        ///< of the first camera's path
  double flow_px = 0;         ///< mean over the frames that have a next one
  double blur_px = 0;         ///< mean over the same
  double depth_coverage = 0;  ///< mean share of pixels
  double textured_share = 0;  ///< mean share of tiles
};

/// The index of a data set while its frames are read in order.
class DatasetIndex {
 public:
  /// Takes the rows of one part, those of a sequence's parts in order. Throws vo::Error for what is
  /// no row.
  void add_rows(const DatasetSequence& sequence, const std::string& rows);

  /// Returns sequences.csv.
  std::string sequences_csv() const;

  /// Returns what distributions of flow, depth and texture over the frames look like, as SVG.
  std::string plot() const;

  /// Returns the statistics of the sequences that were added, by name and in order.
  const std::vector<std::pair<const DatasetSequence*, SequenceStatistics>>& sequences() const {
    return sequences_;
  }

 private:
  struct Distributions {
    ValueCounts flow_px{50};
    ValueCounts depth_coverage{1};
    ValueCounts textured_share{1};
  };

  void add_row(const std::vector<std::string>& cells);

  std::vector<std::pair<const DatasetSequence*, SequenceStatistics>> sequences_;
  std::map<std::string, Distributions> splits_;
  std::string first_camera_;               ///< of the sequence's rig; empty where it has none
  std::array<double, 3> last_position_{};  ///< m, of the frame before, by the first camera
  double first_time_ = 0;                  ///< s, of the sequence's first frame
};

}  // namespace tools
