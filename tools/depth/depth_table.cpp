#include "tools/depth/depth_table.h"

#include <string>
#include <utility>

namespace tools {
namespace {

std::vector<std::pair<std::string, DepthErrors>> subsets(const MapErrors& errors) {
  return {{"confident", errors.confident},     {"all", errors.all},
          {"surface", errors.surface},         {"depth_step", errors.depth_step},
          {"angle_0_30", errors.by_angle[0]},  {"angle_30_60", errors.by_angle[1]},
          {"angle_60_90", errors.by_angle[2]}, {"edge_depth", errors.by_cause[0]},
          {"edge_crease", errors.by_cause[1]}, {"edge_albedo", errors.by_cause[2]},
          {"edge_shadow", errors.by_cause[3]}, {"edge_unlabelled", errors.without_cause}};
}

void append(const DepthErrors& errors, std::vector<TableCell>& row) {
  row.insert(row.end(), {static_cast<double>(errors.count), errors.median_percent,
                         errors.p90_percent, errors.outliers_percent, errors.nees});
}

std::vector<TableColumn> error_columns(const std::string& prefix) {
  return {{prefix + "count", 0},
          {prefix + "median_percent", 3},
          {prefix + "p90_percent", 2},
          {prefix + "outliers_percent", 2},
          {prefix + "nees", 2}};
}

}  // namespace

Table depth_table(const std::vector<MappedFrame>& frames) {
  Table table;
  table.columns = {{"timestamp", 6},       {"baseline_m", 4},   {"anchor", 0},
                   {"found", 0},           {"inconsistent", 0}, {"out_of_view", 0},
                   {"unobservable", 0},    {"ambiguous", 0},    {"no_match", 0},
                   {"density_percent", 1}, {"scale", 4}};
  for (const auto& [name, errors] : subsets({})) {
    for (const TableColumn& column : error_columns(name + "_")) {
      table.columns.push_back(column);
    }
  }
  const auto number = [](std::size_t count) { return static_cast<double>(count); };
  for (const MappedFrame& frame : frames) {
    const vo::ObservationCounts& seen = frame.observations;
    std::vector<TableCell> row{frame.timestamp,           frame.baseline_m,
                               frame.is_host ? 1.0 : 0.0, number(seen.found),
                               number(seen.inconsistent), number(seen.out_of_view),
                               number(seen.unobservable), number(seen.ambiguous),
                               number(seen.no_match),     frame.errors.density_percent,
                               frame.errors.scale};
    for (const auto& [name, errors] : subsets(frame.errors)) {
      append(errors, row);
    }
    table.add_row(std::move(row));
  }
  return table;
}

Table error_table(const MapErrors& errors) {
  Table table;
  table.columns = {{"hypotheses", 0}};
  for (const TableColumn& column : error_columns("")) {
    table.columns.push_back(column);
  }
  for (const auto& [name, some] : subsets(errors)) {
    if (some.count == 0 && name.starts_with("edge_")) {
      continue;  // the sequence has no edge of this cause
    }
    std::vector<TableCell> row{name};
    append(some, row);
    table.add_row(std::move(row));
  }
  return table;
}

}  // namespace tools
