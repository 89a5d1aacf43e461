#include "tools/laboratory/junit.h"

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

/// What junit-10.xsd of Jenkins' xUnit plugin, which most readers follow, has of an element.
struct Rule {
  std::set<std::string> parents;
  std::set<std::string> required;
  std::set<std::string> optional;
};

const std::map<std::string, Rule>& schema() {
  static const std::map<std::string, Rule> rules{
      {"testsuites", {{""}, {}, {"name", "time", "tests", "failures", "disabled", "errors"}}},
      {"testsuite",
       {{"testsuites"},
        {"name"},
        {"tests", "failures", "errors", "time", "disabled", "skipped", "timestamp", "hostname",
         "id", "package"}}},
      {"properties", {{"testsuite"}, {}, {}}},
      {"property", {{"properties"}, {"name", "value"}, {}}},
      {"testcase",
       {{"testsuite"}, {"name"}, {"assertions", "time", "classname", "status", "class", "file"}}},
      {"failure", {{"testcase"}, {}, {"type", "message"}}},
      {"error", {{"testcase"}, {}, {"type", "message"}}}};
  return rules;
}

/// Attributes by name, as they are written.
std::map<std::string, std::string> attributes_of(const std::string& text) {
  static const std::regex pattern(R"x(\s+([a-z]+)="([^"<]*)")x");
  std::map<std::string, std::string> attributes;
  std::size_t length = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
    EXPECT_TRUE(attributes.emplace((*i)[1], (*i)[2]).second) << "twice: " << (*i)[0];
    length += static_cast<std::size_t>(i->length());
  }
  EXPECT_EQ(length, text.size()) << "no attributes: " << text;
  return attributes;
}

void expect_escaped(const std::string& value) {
  static const std::regex pattern(R"(([^&\x01-\x1f]|&(amp|lt|gt|quot|apos);)*)");
  EXPECT_TRUE(std::regex_match(value, pattern)) << value;
}

void expect_allowed(const std::string& name, const std::string& parent,
                    const std::map<std::string, std::string>& attributes) {
  ASSERT_TRUE(schema().contains(name)) << name;
  const Rule& rule = schema().at(name);
  EXPECT_TRUE(rule.parents.contains(parent)) << name << " in " << parent;
  for (const std::string& attribute : rule.required) {
    EXPECT_TRUE(attributes.contains(attribute)) << name << " needs " << attribute;
  }
  for (const auto& [attribute, value] : attributes) {
    EXPECT_TRUE(rule.required.contains(attribute) || rule.optional.contains(attribute))
        << name << " has " << attribute;
    expect_escaped(value);
  }
}

/// That the document is well-formed and has the schema's elements; returns how many of each.
std::map<std::string, int> count_elements(const std::string& xml) {
  static const std::regex tag(R"x(<(/?)([a-z]+)((?:\s+[a-z]+="[^"<]*")*)(/?)>)x");
  std::vector<std::string> open{""};
  std::map<std::string, int> counts;
  const std::string body = xml.substr(xml.find("?>") + 2);
  std::string between = std::regex_replace(body, tag, "");
  EXPECT_THAT(between, testing::MatchesRegex("[ \n]*")) << "neither text nor broken tags";
  for (std::sregex_iterator i(body.begin(), body.end(), tag), end; i != end; ++i) {
    const std::string name = (*i)[2];
    if ((*i)[1] == "/") {
      EXPECT_EQ(open.back(), name);
      open.pop_back();
      continue;
    }
    ++counts[name];
    expect_allowed(name, open.back(), attributes_of((*i)[3]));
    if ((*i)[4] != "/") {
      open.push_back(name);
    }
  }
  EXPECT_EQ(open.size(), 1U) << "all are closed";
  return counts;
}

TEST(Junit, HasACasePerScenarioAndSaysWhatFailed) {
  const tools::ScenarioResult good{.name = "still", .why = "", .trials = {{.time = 1.25}}};
  const tools::ScenarioResult bad{
      .name = "orbit",
      .why = "",
      .trials = {{.time = 2}},
      .checks = {{.metric = "ate_rmse_m", .measured = 0.5, .bound = {.max = 0.25}}}};
  const tools::ScenarioResult broken{
      .name = "odd", .why = "", .trials = {{.problem = "a.toml:3: unknown key \"<x>\" & more"}}};
  const tools::TestResults results{
      .edvo = "1", .tracker = "edvo", .scenarios = {good, bad, broken}};
  const tools::Change change{.scenario = "still",
                             .metric = "ate_rmse_m",
                             .before = 1,
                             .after = 2,
                             .percent = 100,
                             .p_value = 0,
                             .kind = tools::ChangeKind::worse,
                             .is_significant = true,
                             .is_large = true};
  EXPECT_EQ(tools::format_junit(results, {change}), R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="edvo test" tests="3" failures="2" errors="1" time="3.250">
  <testsuite name="edvo" tests="3" failures="2" errors="1" time="3.250">
    <properties>
      <property name="edvo" value="1"/>
      <property name="tracker" value="edvo"/>
      <property name="bounds" value="scenario"/>
    </properties>
    <testcase classname="edvo.scenarios" name="still" time="1.250">
      <failure type="baseline" message="still: ate_rmse_m was 1, is 2 (+100.0 %, p 0): worse"/>
    </testcase>
    <testcase classname="edvo.scenarios" name="orbit" time="2.000">
      <failure type="bound" message="ate_rmse_m is 0.5, expected &lt;= 0.25"/>
    </testcase>
    <testcase classname="edvo.scenarios" name="odd" time="0.000">
      <error type="unusable" message="a.toml:3: unknown key &quot;&lt;x&gt;&quot; &amp; more"/>
    </testcase>
  </testsuite>
</testsuites>
)");
}

TEST(Junit, TellsWhatEndedATrackerApart) {
  using Kind = tools::ProblemKind;
  const auto outcome = [](std::vector<Kind> kinds) {
    tools::ScenarioResult scenario{.name = "orbit"};
    for (const Kind kind : kinds) {
      scenario.trials.push_back({.problem = "it ended", .kind = kind});
    }
    const std::string xml = tools::format_junit({.scenarios = {scenario}}, {});
    const std::size_t start = xml.find("<", xml.find("<testcase") + 1);
    return xml.substr(start, xml.find(" message", start) - start);
  };
  EXPECT_EQ(outcome({Kind::crash}), "<error type=\"crash\"");
  EXPECT_EQ(outcome({Kind::timeout}), "<error type=\"timeout\"");
  EXPECT_EQ(outcome({Kind::tracker}), "<error type=\"tracker\"");
  EXPECT_EQ(outcome({Kind::temporary}), "<error type=\"temporary\"");
  EXPECT_EQ(outcome({Kind::implausible}), "<failure type=\"implausible\"");
  EXPECT_EQ(outcome({Kind::implausible, Kind::crash}), "<error type=\"crash\"")
      << "one element, whatever the other seeds say";
}

TEST(Junit, AllScenariosTogetherAreACaseOfTheirOwn) {
  const tools::ScenarioResult still{.name = "still", .why = "", .trials = {{.time = 1}}};
  const tools::Change change{.scenario = tools::kAllScenarios,
                             .metric = "ate_rmse_m",
                             .is_significant = true,
                             .is_large = true};
  const std::string xml = tools::format_junit({.scenarios = {still}}, {change});
  EXPECT_THAT(xml, testing::HasSubstr("tests=\"2\" failures=\"1\" errors=\"0\""));
  EXPECT_THAT(xml, testing::HasSubstr("name=\"all scenarios\" time=\"0.000\">\n"
                                      "      <failure type=\"baseline\""));
}

TEST(Junit, FollowsTheCommonSchemaWhateverTheTextsHold) {
  const std::string odd = "a \"b\" 'c' <d> & \x01\n\t \xff \u20ac ]]>";
  tools::TestResults results{.edvo = "1", .tracker = "vo --in {sequence} && " + odd};
  results.scenarios.push_back({.name = odd, .trials = {{.problem = odd}}});
  results.scenarios.push_back({.name = "still", .trials = {{.time = 1}}});
  results.scenarios.push_back(
      {.name = "orbit",
       .trials = {{.time = 2}},
       .checks = {{.metric = "ate_rmse_m", .measured = 0.5, .bound = {.max = 0.25}}}});
  const auto counts = count_elements(tools::format_junit(results, {}));
  EXPECT_EQ(counts.at("testcase"), 3);
  EXPECT_EQ(counts.at("error"), 1);
  EXPECT_EQ(counts.at("failure"), 1);
}

}  // namespace
