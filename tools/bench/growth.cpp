#include "tools/bench/growth.h"

#include <cstddef>
#include <functional>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

/// One growth table before measurement: its peers, and how to read x and ms from a summary.
struct Sweep {
  std::string quantity;
  std::string timed;
  std::vector<Peer> peers;
  std::function<double(std::size_t row, const Summary& summary)> x;
  std::function<double(const Summary& summary)> ms;
};

Peer with_option(vo::TrackerOptions options, const std::string& key, const std::string& value) {
  std::vector<vo::Field> fields = vo::fields_of(options);
  vo::set_field(fields, key, value);
  return edvo_peer(vo::concat(key, "=", value), options);
}

std::vector<Peer> with_options(const vo::TrackerOptions& base, const std::string& key,
                               const std::vector<std::string>& values) {
  std::vector<Peer> peers;
  peers.reserve(values.size());
  for (const std::string& value : values) {
    peers.push_back(with_option(base, key, value));
  }
  return peers;
}

/// Returns a peer that tracks frames resized to `size`; resizing is not timed.
Peer at_size(const vo::TrackerOptions& base, cv::Size size) {
  const std::string name = vo::concat(size.width, "x", size.height);
  const Peer full = edvo_peer(name, base);
  return {name, [full, size](const vo::PinholeCamera& camera) {
            const FrameTracker track = full.start(resized(camera, size));
            return
                [track, size](const vo::RgbdFrame& frame) { return track(resized(frame, size)); };
          }};
}

double cpu_ms(const Summary& summary) {
  return summary.cpu_ms;
}

Sweep point_sweep(const vo::TrackerOptions& base) {
  return {"points", "cpu",
          with_options(base, "points.max_points", {"250", "500", "1000", "2000", "4000", "8000"}),
          [](std::size_t, const Summary& summary) { return summary.points; }, cpu_ms};
}

/// Returns the sweep over pyramid levels, without a line fit: coarse levels cost little and save
/// iterations of the fine ones.
Sweep level_sweep(const vo::TrackerOptions& base) {
  return {"levels", "", with_options(base, "pyramid.levels", {"1", "2", "3", "4", "5"}),
          [](std::size_t row, const Summary&) { return static_cast<double>(row + 1); }, cpu_ms};
}

Sweep size_sweep(const vo::TrackerOptions& base, const vo::PinholeCamera& camera) {
  Sweep sweep{"pixels", "cpu", {}, {}, cpu_ms};
  std::vector<double> pixels;
  for (const int quarters : {1, 2, 4, 8}) {
    const cv::Size size(camera.width * quarters / 4, camera.height * quarters / 4);
    sweep.peers.push_back(at_size(base, size));
    pixels.push_back(size.area());
  }
  sweep.x = [pixels](std::size_t row, const Summary&) { return pixels[row]; };
  return sweep;
}

GrowthTable make_table(const Sweep& sweep, std::vector<Summary> rows) {
  GrowthTable table{.quantity = sweep.quantity, .timed = sweep.timed, .rows = std::move(rows)};
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    table.x.push_back(sweep.x(row, table.rows[row]));
    table.ms.push_back(sweep.ms(table.rows[row]));
  }
  if (!table.timed.empty()) {
    table.fit = fit_line(table.x, table.ms);
  }
  return table;
}

}  // namespace

std::vector<GrowthTable> measure_growth(const Frames& input, const vo::TrackerOptions& base,
                                        const RaceOptions& options, const vo::Progress& progress) {
  const std::vector<Sweep> sweeps = {point_sweep(base), level_sweep(base),
                                     size_sweep(base, input.camera)};
  std::vector<Peer> peers;
  for (const Sweep& sweep : sweeps) {
    peers.insert(peers.end(), sweep.peers.begin(), sweep.peers.end());
  }
  const std::vector<RaceResult> results = race(input, peers, options, progress);
  std::vector<GrowthTable> tables;
  auto next = results.begin();
  for (const Sweep& sweep : sweeps) {
    std::vector<Summary> rows;
    for (std::size_t row = 0; row < sweep.peers.size(); ++row) {
      rows.push_back(summarize(*next++, input, options));
    }
    tables.push_back(make_table(sweep, std::move(rows)));
  }
  return tables;
}

}  // namespace tools
