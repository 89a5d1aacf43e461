#include "tools/report/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "tools/json/document.h"
#include "tools/report/repeat_command.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/version.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string verdict(const Outcome& outcome, const Colours& colours) {
  const auto held = std::count_if(outcome.checks.begin(), outcome.checks.end(),
                                  [](const BoundCheck& check) { return check.holds; });
  return vo::concat(
      outcome.passed() ? colours.paint(Tone::good, "PASS") : colours.paint(Tone::bad, "FAIL"), "  ",
      held, " of ", outcome.checks.size(), " bounds");
}

Json field_json(const vo::Field& field) {
  const std::string text = field.get();
  switch (field.type) {
    case vo::FieldType::boolean:
    case vo::FieldType::integer:
    case vo::FieldType::real:
      return Json::parse(text);
    case vo::FieldType::reals:
      return Json::parse("[" + text + "]");
    case vo::FieldType::text:
      break;
  }
  return text;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

/// Returns whether a metric is shown: it was measured or has a bound.
bool is_shown(double value, const BoundCheck* check) {
  return std::isfinite(value) || check != nullptr;
}

const BoundCheck* find_check(const Outcome& outcome, const std::string& metric) {
  const auto found = std::find_if(outcome.checks.begin(), outcome.checks.end(),
                                  [&](const BoundCheck& check) { return check.metric == metric; });
  return found == outcome.checks.end() ? nullptr : &*found;
}

}  // namespace

std::string shown_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string bound_text(const Bound& bound) {
  std::string text;
  if (std::isfinite(bound.min)) {
    text += ">= " + shown_number(bound.min);
  }
  if (std::isfinite(bound.max)) {
    text += (text.empty() ? "" : ", ") + ("<= " + shown_number(bound.max));
  }
  return text;
}

Json report_json(const Scenario& scenario, const Outcome& outcome) {
  Json report;
  report["scenario"] = scenario.name;
  report["why"] = scenario.why;
  report["passed"] = outcome.passed();
  report["frames"] = outcome.tracking.frames.size();
  report["path_length_m"] = vo::path_length(outcome.truth);
  for (const auto& [metric, value] : metric_values(outcome.metrics)) {
    report["metrics"][metric] = number_or_null(value);
  }
  for (const BoundCheck& check : outcome.checks) {
    report["bounds"][check.metric] = {{"min", number_or_null(check.bound.min)},
                                      {"max", number_or_null(check.bound.max)},
                                      {"holds", check.holds}};
  }
  report["notes"] = outcome.notes;
  Scenario copy = scenario;
  report["options"] = fields_json(vo::fields_of(copy));
  return json_document({"run"}, report);
}

std::string report_markdown(const Scenario& scenario, const Outcome& outcome) {
  std::string text = vo::concat(
      "# ", scenario.name, "\n\n", scenario.why, "\n\n", verdict(outcome, {}), "; ",
      outcome.tracking.frames.size(), " frames, ", shown_number(vo::path_length(outcome.truth)),
      " m of path.\n\n", "| metric | measured | bound | |\n|---|---:|---|---|\n");
  for (const auto& [metric, value] : metric_values(outcome.metrics)) {
    const BoundCheck* check = find_check(outcome, metric);
    if (!is_shown(value, check)) {
      continue;
    }
    text += vo::concat("| ", metric, " | ", shown_number(value), " | ",
                       check != nullptr ? bound_text(check->bound) : "", " | ",
                       check == nullptr ? "" : (check->holds ? "ok" : "VIOLATED"), " |\n");
  }
  text += "\n![trajectory](trajectory.svg)\n\n";
  text +=
      "Pictures of single frames are in `panels/`, the estimate in `trajectory.txt`, every "
      "frame's status in `frames.csv`, the sequence in `sequence/`.\n\n";
  const RepeatCommand repeat = repeat_run(scenario);
  return text + vo::concat("Repeat in `", repeat.folder, "` with `", repeat.command, "` (edvo ",
                           vo::version(), ").\n");
}

std::string report_table(const Scenario& scenario, const Outcome& outcome, const Colours& colours) {
  constexpr std::size_t kNameWidth = 28;
  constexpr std::size_t kValueWidth = 14;
  std::size_t bound_width = kValueWidth;
  for (const BoundCheck& check : outcome.checks) {
    bound_width = std::max(bound_width, bound_text(check.bound).size() + 1);
  }
  std::string text =
      padded(scenario.name, kNameWidth) + padded("measured", kValueWidth) + "bound\n";
  for (const auto& [metric, value] : metric_values(outcome.metrics)) {
    const BoundCheck* check = find_check(outcome, metric);
    if (!is_shown(value, check)) {
      continue;
    }
    text += padded(metric, kNameWidth) + padded(shown_number(value), kValueWidth);
    if (check != nullptr) {
      text +=
          padded(bound_text(check->bound), bound_width) +
          (check->holds ? colours.paint(Tone::good, "ok") : colours.paint(Tone::bad, "VIOLATED"));
    }
    text += "\n";
  }
  return text + verdict(outcome, colours) + "\n";
}

Json fields_json(const std::vector<vo::Field>& fields) {
  Json json = Json::object();
  for (const vo::Field& field : fields) {
    json[field.key] = field_json(field);
  }
  return json;
}

Json time_json(const vo::TimeSummary& times) {
  return {{"median", times.median_ms},
          {"p90", times.p90_ms},
          {"pyramid", times.pyramid_ms},
          {"edges", times.edges_ms},
          {"alignment", times.alignment_ms}};
}

}  // namespace tools
