#include "tools/report/static_page.h"

#include "tools/plot/escaped_markup.h"
#include "tools/report/report.h"
#include "tools/report/trajectory_plot.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr const char* kStyle =
    "<style>body{font:16px/1.5 sans-serif;max-width:60rem;margin:auto;padding:1rem;color:#222;"
    "background:#fff}td,th{padding:.2rem .8rem;text-align:left}.note{border:1px solid #b58900;"
    "padding:.5rem 1rem}svg{max-width:100%;height:auto}</style>\n";

std::string metric_row(const ReportedMetric& metric) {
  const std::string verdict = metric.holds ? "ok" : "VIOLATED";
  return vo::concat("<tr><td>", escaped_markup(metric.name), "</td><td>",
                    shown_number(metric.value), "</td><td>",
                    metric.bound ? escaped_markup(bound_text(*metric.bound)) : "", "</td><td>",
                    metric.bound ? verdict : "", "</td></tr>\n");
}

std::string section(const ScenarioReport& report) {
  std::string text =
      vo::concat("<h2>", escaped_markup(report.name), ": ", report.passed() ? "PASS" : "FAIL",
                 "</h2>\n<p>", escaped_markup(report.why), "</p>\n");
  if (!report.problem.empty()) {
    text += "<p>" + escaped_markup(report.problem) + "</p>\n";
  }
  text += "<table><tr><th>metric</th><th>measured</th><th>bound</th><th></th></tr>\n";
  for (const ReportedMetric& metric : report.metrics) {
    text += metric_row(metric);
  }
  text += "</table>\n<p><code>" + escaped_markup(report.repeat.command) + "</code></p>\n";
  if (!report.estimate.empty()) {
    text += draw_trajectory(report.truth, report.estimate, report.alignment);
  }
  return text;
}

}  // namespace

std::string static_page(const std::vector<ScenarioReport>& scenarios, std::string_view note) {
  std::string text = vo::concat(kStyle, "<h1>edvo report</h1>\n<p class=\"note\">",
                                escaped_markup(note), "</p>\n");
  for (const ScenarioReport& report : scenarios) {
    text += section(report);
  }
  return text;
}

}  // namespace tools
