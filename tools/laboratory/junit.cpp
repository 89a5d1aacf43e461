#include "tools/laboratory/junit.h"

#include <algorithm>
#include <optional>

#include "tools/plot/escaped_markup.h"
#include "tools/plot/table.h"
#include "tools/processes/readable_text.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

/// Returns the text in a form fit for an XML attribute value.
std::string escaped(const std::string& text) {
  return escaped_markup(readable_text(text));
}

/// Returns the kind of problem that a reader must know of first: the scenario's own, then the
/// tracker's in the order of the enumeration; none if every trial was measured.
std::optional<ProblemKind> problem_of(const ScenarioResult& scenario) {
  std::optional<ProblemKind> first;
  for (const TrialResult& trial : scenario.trials) {
    if (!trial.problem.empty() && (!first || trial.kind < *first)) {
      first = trial.kind;
    }
  }
  return first;
}

/// What a test case says of its scenario.
struct CaseOutcome {
  enum class Kind { passed, failure, error } kind = Kind::passed;
  std::string type;
  std::string message;
};

/// Returns at most one failure or error, as some readers expect.
CaseOutcome outcome_of(const ScenarioResult& scenario, const std::vector<Change>& changes) {
  using Kind = CaseOutcome::Kind;
  std::vector<std::string> sentences = complaints(scenario);
  const std::vector<std::string> alarms = alarms_of(scenario.name, changes);
  const bool is_bound = !sentences.empty();
  sentences.insert(sentences.end(), alarms.begin(), alarms.end());
  if (const std::optional<ProblemKind> problem = problem_of(scenario)) {
    const bool is_judged = *problem == ProblemKind::implausible;
    return {.kind = is_judged ? Kind::failure : Kind::error,
            .type = std::string(vo::to_string(*problem)),
            .message = joined(sentences)};
  }
  return {.kind = sentences.empty() ? Kind::passed : Kind::failure,
          .type = is_bound ? "bound" : "baseline",
          .message = joined(sentences)};
}

std::string property(const char* name, const std::string& value) {
  return vo::concat("      <property name=\"", name, "\" value=\"", escaped(value), "\"/>\n");
}

/// Returns the scenarios, and after them one without trials that stands for all together if the
/// changes have something of it.
std::vector<ScenarioResult> tested(const TestResults& results, const std::vector<Change>& changes) {
  std::vector<ScenarioResult> scenarios = results.scenarios;
  if (std::any_of(changes.begin(), changes.end(),
                  [](const Change& change) { return change.scenario == kAllScenarios; })) {
    scenarios.push_back({.name = kAllScenarios, .why = "", .trials = {}, .checks = {}});
  }
  return scenarios;
}

std::string test_case(const ScenarioResult& scenario, const CaseOutcome& outcome) {
  const char* name = outcome.kind == CaseOutcome::Kind::error ? "error" : "failure";
  return vo::concat("    <testcase classname=\"edvo.scenarios\" name=\"", escaped(scenario.name),
                    "\" time=\"", format_decimals(scenario.time(), 3), "\"",
                    outcome.kind == CaseOutcome::Kind::passed
                        ? "/>\n"
                        : vo::concat(">\n      <", name, " type=\"", outcome.type, "\" message=\"",
                                     escaped(outcome.message), "\"/>\n    </testcase>\n"));
}

}  // namespace

std::string format_junit(const TestResults& results, const std::vector<Change>& changes) {
  std::size_t errors = 0;
  std::size_t failures = 0;
  double time = 0;
  std::string cases;
  const std::vector<ScenarioResult> scenarios = tested(results, changes);
  for (const ScenarioResult& scenario : scenarios) {
    const CaseOutcome outcome = outcome_of(scenario, changes);
    errors += outcome.kind == CaseOutcome::Kind::error ? 1 : 0;
    failures += outcome.kind == CaseOutcome::Kind::failure ? 1 : 0;
    time += scenario.time();
    cases += test_case(scenario, outcome);
  }
  const std::string counts =
      vo::concat(" tests=\"", scenarios.size(), "\" failures=\"", failures, "\" errors=\"", errors,
                 "\" time=\"", format_decimals(time, 3), "\"");
  const std::string properties = vo::concat(
      "    <properties>\n", property("edvo", results.edvo), property("tracker", results.tracker),
      property("bounds", std::string(vo::to_string(results.bounds))), "    </properties>\n");
  return vo::concat("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"edvo test\"",
                    counts, ">\n  <testsuite name=\"", escaped(results.tracker), "\"", counts,
                    ">\n", properties, cases, "  </testsuite>\n</testsuites>\n");
}

}  // namespace tools
