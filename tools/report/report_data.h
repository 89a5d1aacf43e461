#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/report/scenario_report.h"

namespace tools {

/// Version of the data format; a changed meaning or a removed key needs a new version.
constexpr int kReportDataVersion = 2;

/// Returns the data of the HTML report. web/src/data.ts declares its format and the meaning of each
/// key; a test type-checks this output against it.
///
///     { "schema": "edvo-report", "version": 1, "generator": "edvo ...", "scenarios": [ {
///         "name", "why", "command", "passed", "problem"?, "alignment", "camera"?,
///         "metrics": [ { "name", "value", "min", "max", "holds" } ],  null = unmeasured, unbounded
///         "notes": [ text ],
///         "options": [ { "key", "value", "preset", "help" } ],
///         "frames": { one array per quantity, one element per frame: "timestamp", "truth",
///                     "estimate", "aligned", "position_m", ...; "tracking"?: { "status", ... } },
///         "stride", "pictures": [ { "frame", "size", "colour", ... } ],  base64 of WebP files
///         "cloud"?: { "count", "origin", "step", "positions", "colours" },
///         "times"?: { "pyramid_ms", "edges_ms", "alignment_ms" }  differ from run to run
///     } ] }
///
/// Poses are [tx, ty, tz, qx, qy, qz, qw] of T_world_camera, m, or null. Everything except `times`
/// depends only on the input.
nlohmann::ordered_json report_data(const std::vector<ScenarioReport>& scenarios);

/// Returns a report of an entry of `scenarios` that another process made: its verdict, notes and
/// poses, and the entry itself as `data`, so that `report_data` gives the entry again. Throws
/// nlohmann::json::exception where it is no such entry.
ScenarioReport report_of_data(const nlohmann::ordered_json& entry);

}  // namespace tools
