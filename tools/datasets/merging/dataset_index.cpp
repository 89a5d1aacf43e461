#include "tools/datasets/merging/dataset_index.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tools/plot/table.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

// The columns of frames.csv that statistics are made of, and the number of all.
constexpr std::size_t kTime = 3;
constexpr std::size_t kPosition = 7;
constexpr std::size_t kFlow = 14;
constexpr std::size_t kBlur = 15;
constexpr std::size_t kCoverage = 16;
constexpr std::size_t kTextured = 17;
constexpr std::size_t kColumns = 19;
constexpr std::size_t kCamera = kColumns;  // one more where a rig took the frames

/// Returns the mean of `count` values of which that of all but one is known, and the last one.
double mean_with(double mean, double value, std::size_t count) {
  return mean + (value - mean) / static_cast<double>(count);
}

}  // namespace

std::vector<std::string> cells_of_row(std::string_view row) {
  std::vector<std::string> cells(1);
  for (const char c : row) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  vo::require(cells.size() == kColumns || cells.size() == kCamera + 1, "frames.csv: ", cells.size(),
              " columns, expected ", kColumns, ", or one more of a rig");
  return cells;
}

void ValueCounts::add(double value) {
  const double bin = std::clamp(value / most_, 0.0, 1.0) * static_cast<double>(kBins);
  ++counts_[std::min(static_cast<std::size_t>(bin), kBins - 1)];
  ++total_;
}

std::vector<PlotPoint> ValueCounts::distribution() const {
  constexpr double kPercent = 100;
  std::vector<PlotPoint> points;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < kBins && total_ > 0; ++i) {
    sum += counts_[i];
    points.push_back({most_ * static_cast<double>(i + 1) / static_cast<double>(kBins),
                      kPercent * static_cast<double>(sum) / static_cast<double>(total_)});
  }
  return points;
}

void DatasetIndex::add_rows(const DatasetSequence& sequence, const std::string& rows) {
  if (sequences_.empty() || sequences_.back().first != &sequence) {
    sequences_.emplace_back(&sequence, SequenceStatistics{});
  }
  std::istringstream lines(rows);
  for (std::string row; std::getline(lines, row);) {
    add_row(cells_of_row(row));
  }
}

void DatasetIndex::add_row(const std::vector<std::string>& cells) {
  const auto& [sequence, unused] = sequences_.back();
  SequenceStatistics& statistics = sequences_.back().second;
  Distributions& split = splits_[sequence->split];
  const double time = vo::parse_real(cells[kTime]);
  std::array<double, 3> position{};
  for (std::size_t i = 0; i < position.size(); ++i) {
    position[i] = vo::parse_real(cells[kPosition + i]);
  }
  const std::string camera = cells.size() > kCamera ? cells[kCamera] : "";
  if (statistics.frames == 0) {
    first_camera_ = camera;
    first_time_ = time;
    last_position_ = position;
  }
  if (camera == first_camera_) {
    statistics.length_m +=
        std::hypot(position[0] - last_position_[0], position[1] - last_position_[1],
                   position[2] - last_position_[2]);
    last_position_ = position;
    statistics.duration_s = time - first_time_;
  }
  ++statistics.frames;
  if (!cells[kFlow].empty()) {
    const double flow_px = vo::parse_real(cells[kFlow]);
    statistics.flow_px = mean_with(statistics.flow_px, flow_px, statistics.frames);
    statistics.blur_px =
        mean_with(statistics.blur_px, vo::parse_real(cells[kBlur]), statistics.frames);
    split.flow_px.add(flow_px);
  }
  const double coverage = vo::parse_real(cells[kCoverage]);
  const double textured = vo::parse_real(cells[kTextured]);
  statistics.depth_coverage = mean_with(statistics.depth_coverage, coverage, statistics.frames);
  statistics.textured_share = mean_with(statistics.textured_share, textured, statistics.frames);
  split.depth_coverage.add(coverage);
  split.textured_share.add(textured);
}

std::string DatasetIndex::sequences_csv() const {
  Table table{.columns = {{"split"},
                          {"sequence"},
                          {"scene"},
                          {"path"},
                          {"sensor"},
                          {"seed"},
                          {"frames"},
                          {"duration_s"},
                          {"length_m"},
                          {"flow_px"},
                          {"blur_px"},
                          {"depth_coverage"},
                          {"textured_share"},
                          {"licence"}}};
  for (const auto& [sequence, statistics] : sequences_) {
    std::string licence = sequence->licence;
    std::replace(licence.begin(), licence.end(), ',', ';');
    table.add_row({sequence->split, sequence->name, sequence->scene, sequence->path,
                   sequence->sensor, static_cast<double>(sequence->seed),
                   static_cast<double>(statistics.frames), statistics.duration_s,
                   statistics.length_m, statistics.flow_px, statistics.blur_px,
                   statistics.depth_coverage, statistics.textured_share, licence});
  }
  return as_csv(table);
}

std::string DatasetIndex::plot() const {
  const PlotAxis share{.title = "frames, %"};
  std::vector<PlotPanel> panels{{.x = {.title = "median flow to the next frame, px"}, .y = share},
                                {.x = {.title = "share of pixels with depth"}, .y = share},
                                {.x = {.title = "share of tiles with texture"}, .y = share}};
  int style = 0;
  for (const auto& [split, values] : splits_) {
    const std::array<const ValueCounts*, 3> counts{&values.flow_px, &values.depth_coverage,
                                                   &values.textured_share};
    for (std::size_t i = 0; i < counts.size(); ++i) {
      panels[i].series.push_back({.name = split,
                                  .style = style,
                                  .mark = PlotMark::line,
                                  .points = counts[i]->distribution()});
    }
    ++style;
  }
  return draw_plot("Share of the frames with at most so much", panels);
}

}  // namespace tools
