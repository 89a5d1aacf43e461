#include "tools/bench/bench_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>

#include "tools/bench/opencv_peer.h"
#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kThreads = 1;
constexpr double kNanosecondsPerMs = 1e6;

/// Returns one line of a table, formatted as by printf.
template <typename... Values>
std::string line(const char* format, Values... values) {
  std::array<char, 240> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string header(const BenchReport& report) {
  return vo::concat(report.input, ": ", report.frames, " frames of ", report.width, "x",
                    report.height, " in memory, the first ", report.options.warm_up,
                    " not counted, median of ", report.options.repeats, " repeats\n", report.cpu,
                    ", threads: ", kThreads, "\n");
}

std::string titles(const char* first) {
  return line("%-22s %8s %8s %8s | %8s %8s %8s %8s | %7s %7s %9s %9s %9s %9s", first, "ms", "p90",
              "cpu ms", "pyramid", "edges", "align", "map", "points", "tracked", "map MiB", "RPE m",
              "RPE deg", "ATE m");
}

/// Returns a column that is `-` where the value is unknown.
std::string column(double value, int digits) {
  return std::isfinite(value) ? line("%9.*f", digits, value) : line("%9s", "-");
}

std::string row(const Summary& s) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Accuracy accuracy = s.accuracy.value_or(Accuracy{kNone, kNone, kNone});
  return line("%-22s %8.2f %8.2f %8.2f | %8.2f %8.2f %8.2f %8.2f | %7.0f %6.1f%%", s.name.c_str(),
              s.median_ms, s.p90_ms, s.cpu_ms, s.stages.pyramid_ms, s.stages.edges_ms,
              s.stages.alignment_ms, s.stages.map_ms, s.points, 100 * s.tracked_fraction) +
         " " + column(s.map_mib.value_or(kNone), 1) + " " +
         column(accuracy.rpe_translation_rmse_m, 4) + " " +
         column(accuracy.rpe_rotation_rmse_deg, 3) + " " + column(accuracy.ate_rmse_m, 4);
}

std::string contestants_table(const BenchReport& report) {
  const Summary* unit = yardstick(report.peers);
  std::string text = titles("ms per frame");
  text += unit != nullptr ? "  faster than " + unit->name + "\n" : "\n";
  for (const Summary& s : report.peers) {
    text += row(s) + (unit != nullptr ? line("  %.1fx", unit->cpu_ms / s.cpu_ms) : "") + "\n";
  }
  return text;
}

std::string growth_table(const GrowthTable& table) {
  std::string text = titles(("with " + table.quantity).c_str()) + "\n";
  for (const Summary& s : table.rows) {
    text += row(s) + "\n";
  }
  if (table.fit) {
    text +=
        line("%s: %.3g ms + %.3g ns for each of the %s\n", table.timed.c_str(),
             table.fit->intercept, kNanosecondsPerMs * table.fit->slope, table.quantity.c_str());
  }
  return text;
}

Json accuracy_json(const Summary& s) {
  if (!s.accuracy) {
    return nullptr;
  }
  return {{"rpe_translation_rmse_m", s.accuracy->rpe_translation_rmse_m},
          {"rpe_rotation_rmse_deg", s.accuracy->rpe_rotation_rmse_deg},
          {"ate_rmse_m", s.accuracy->ate_rmse_m}};
}

Json summary_json(const Summary& s) {
  return {{"name", s.name},
          {"ms_per_frame",
           {{"median", s.median_ms},
            {"p90", s.p90_ms},
            {"cpu", s.cpu_ms},
            {"pyramid", s.stages.pyramid_ms},
            {"edges", s.stages.edges_ms},
            {"alignment", s.stages.alignment_ms},
            {"map", s.stages.map_ms}}},
          {"points", s.points},
          {"keyframes", s.keyframes},
          {"tracked_fraction", s.tracked_fraction},
          {"map_mib", s.map_mib ? Json(*s.map_mib) : Json()},
          {"accuracy", accuracy_json(s)}};
}

Json growth_json(const GrowthTable& table) {
  Json json = {{"quantity", table.quantity}, {"timed", table.timed}, {"rows", Json::array()}};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    Json row = summary_json(table.rows[i]);
    row[table.quantity] = table.x[i];
    json["rows"].push_back(std::move(row));
  }
  if (table.fit) {
    json["fit"] = {{"ns_per_one", kNanosecondsPerMs * table.fit->slope},
                   {"rest_ms", table.fit->intercept}};
  }
  return json;
}

}  // namespace

BenchReport race_peers(const std::string& input, const Frames& frames, LineUp line,
                       const RaceOptions& options, const vo::Progress& progress) {
  BenchReport report{.input = input,
                     .cpu = cpu_model(),
                     .width = frames.camera.width,
                     .height = frames.camera.height,
                     .frames = frames.frames.size(),
                     .options = options,
                     .absent = std::move(line.absent)};
  for (const RaceResult& result : race(frames, line.peers, options, progress)) {
    report.peers.push_back(summarize(result, frames, options));
  }
  return report;
}

std::string cpu_model() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string text; std::getline(stream, text);) {
    const auto colon = text.find(": ");
    if (text.starts_with("model name") && colon != std::string::npos) {
      return text.substr(colon + 2);
    }
  }
  return "unknown";
}

const Summary* yardstick(const std::vector<Summary>& peers) {
  if (peers.size() < 2) {
    return nullptr;
  }
  const auto peer = std::find_if(peers.begin(), peers.end(), [](const Summary& s) {
    return s.name == vo::to_string(OpencvOdometry::rgbd);
  });
  if (peer != peers.end()) {
    return &*peer;
  }
  return &*std::max_element(peers.begin(), peers.end(),
                            [](const Summary& a, const Summary& b) { return a.cpu_ms < b.cpu_ms; });
}

std::string bench_table(const BenchReport& report) {
  std::string text = header(report) + "\n" + contestants_table(report);
  for (const Absence& absence : report.absent) {
    text += absence.name + ": " + absence.reason + "\n";
  }
  for (const GrowthTable& table : report.growth) {
    text += "\n" + growth_table(table);
  }
  return text;
}

Json bench_json(const BenchReport& report) {
  Json json = {{"input", report.input},
               {"cpu", report.cpu},
               {"threads", kThreads},
               {"width", report.width},
               {"height", report.height},
               {"frames", report.frames},
               {"warm_up", report.options.warm_up},
               {"repeats", report.options.repeats},
               {"contestants", Json::array()},
               {"absent", Json::array()}};
  const Summary* unit = yardstick(report.peers);
  for (const Summary& s : report.peers) {
    Json row = summary_json(s);
    if (unit != nullptr) {
      row["faster_than"] = {{"name", unit->name}, {"ratio", unit->cpu_ms / s.cpu_ms}};
    }
    json["contestants"].push_back(std::move(row));
  }
  for (const Absence& absence : report.absent) {
    json["absent"].push_back({{"name", absence.name}, {"reason", absence.reason}});
  }
  for (const GrowthTable& table : report.growth) {
    json["growth"].push_back(growth_json(table));
  }
  return json_document({"bench"}, json);
}

}  // namespace tools
