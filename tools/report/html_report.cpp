#include "tools/report/html_report.h"

#include <algorithm>
#include <string_view>

#include <nlohmann/json.hpp>

#include "tools/report/report_data.h"
#include "tools/report/static_page.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Content security policy: nothing but the file's own contents may be loaded.
constexpr const char* kPolicy =
    "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src "
    "'unsafe-inline'";

std::string head(const std::vector<ScenarioReport>& scenarios, std::string_view style) {
  const auto passed = std::count_if(scenarios.begin(), scenarios.end(),
                                    [](const ScenarioReport& report) { return report.passed(); });
  return vo::concat(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"",
      kPolicy, "\">\n<title>edvo report: ", passed, " of ", scenarios.size(),
      " scenarios passed</title>\n<style>", style, "</style>\n</head>\n");
}

/// Returns JSON for a script element, with `<` escaped so that it cannot end the element.
std::string json_for_script(const nlohmann::ordered_json& data) {
  const std::string text =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    c == '<' ? safe += "\\u003c" : safe += c;
  }
  return safe;
}

}  // namespace

std::string html_report(const std::vector<ScenarioReport>& scenarios, const ReportBundle& bundle) {
  if (!bundle.missing.empty()) {
    return head(scenarios, "") + "<body>\n" + static_page(scenarios, bundle.missing) +
           "</body>\n</html>\n";
  }
  return vo::concat(head(scenarios, bundle.style),
                    "<body>\n<noscript>This report needs JavaScript; report.md says the same "
                    "without.</noscript>\n<div id=\"report\"></div>\n"
                    "<script type=\"application/json\" id=\"edvo-data\">",
                    json_for_script(report_data(scenarios)), "</script>\n<script>", bundle.script,
                    "</script>\n</body>\n</html>\n");
}

}  // namespace tools
