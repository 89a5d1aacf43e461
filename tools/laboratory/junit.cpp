#include "tools/laboratory/junit.h"

#include "tools/plot/escaped_markup.h"
#include "tools/plot/table.h"
#include "tools/processes/readable_text.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns the text in a form fit for an XML attribute value.
std::string escaped(const std::string& text) {
  return escaped_markup(readable_text(text));
}

std::vector<std::string> alarms_of(const std::string& scenario,
                                   const std::vector<Change>& changes) {
  std::vector<std::string> sentences;
  for (const Change& change : changes) {
    if (change.is_alarm() && change.scenario == scenario) {
      sentences.push_back(describe(change));
    }
  }
  return sentences;
}

std::string element(const char* name, const char* type, const std::string& message) {
  return vo::concat("      <", name, " type=\"", type, "\" message=\"", escaped(message), "\"/>\n");
}

/// Returns the child of a test case: at most one failure or error, as some readers expect.
std::string outcome_of(const ScenarioResult& scenario, const std::vector<std::string>& alarms) {
  std::vector<std::string> sentences = complaints(scenario);
  const bool is_error = scenario.verdict() == Verdict::error;
  const char* type = is_error ? "not_measured" : sentences.empty() ? "baseline" : "bound";
  sentences.insert(sentences.end(), alarms.begin(), alarms.end());
  std::string message;
  for (const std::string& sentence : sentences) {
    message += (message.empty() ? "" : "; ") + sentence;
  }
  return sentences.empty() ? "" : element(is_error ? "error" : "failure", type, message);
}

std::string test_case(const ScenarioResult& scenario, const std::vector<Change>& changes) {
  const std::string outcome = outcome_of(scenario, alarms_of(scenario.name, changes));
  return vo::concat("    <testcase classname=\"edvo.scenarios\" name=\"", escaped(scenario.name),
                    "\" time=\"", format_decimals(scenario.time(), 3), "\"",
                    outcome.empty() ? "/>\n" : ">\n" + outcome + "    </testcase>\n");
}

}  // namespace

std::string format_junit(const TestResults& results, const std::vector<Change>& changes) {
  std::size_t errors = 0;
  std::size_t failures = 0;
  double time = 0;
  std::string cases;
  for (const ScenarioResult& scenario : results.scenarios) {
    const bool is_error = scenario.verdict() == Verdict::error;
    const bool fails =
        scenario.verdict() == Verdict::failed || !alarms_of(scenario.name, changes).empty();
    errors += is_error ? 1 : 0;
    failures += !is_error && fails ? 1 : 0;
    time += scenario.time();
    cases += test_case(scenario, changes);
  }
  const std::string counts =
      vo::concat(" tests=\"", results.scenarios.size(), "\" failures=\"", failures, "\" errors=\"",
                 errors, "\" time=\"", format_decimals(time, 3), "\"");
  return vo::concat("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"edvo test\"",
                    counts, ">\n  <testsuite name=\"", escaped(results.tracker), "\"", counts,
                    ">\n", cases, "  </testsuite>\n</testsuites>\n");
}

}  // namespace tools
