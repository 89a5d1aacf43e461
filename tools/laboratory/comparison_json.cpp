#include "tools/laboratory/comparison_json.h"

#include "tools/json/document.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

Json change_json(const Change& change) {
  return {{"scenario", change.scenario},
          {"metric", change.metric},
          {"before", change.before},
          {"after", change.after},
          {"change_percent", change.percent},
          {"p_value", change.p_value},
          {"kind", to_text(change.kind)},
          {"is_significant", change.is_significant},
          {"is_large", change.is_large},
          {"is_alarm", change.is_alarm()},
          {"note", change.note}};
}

}  // namespace

Json comparison_json(const TestResults& before, const TestResults& after,
                     const std::vector<Change>& changes, const ComparisonOptions& options) {
  Json list = Json::array();
  for (const Change& change : changes) {
    list.push_back(change_json(change));
  }
  return json_document({"comparison"}, {{"level", options.level},
                                        {"worse_percent", options.worse_percent},
                                        {"better_percent", options.better_percent},
                                        {"has_alarm", has_alarm(changes)},
                                        {"changes", list},
                                        {"only_before", missing_scenarios(before, after)},
                                        {"only_after", missing_scenarios(after, before)}});
}

Json self_comparison_json(int alarms, int comparisons, const ComparisonOptions& options) {
  return json_document({"self_comparison"}, {{"level", options.level},
                                             {"comparisons", comparisons},
                                             {"alarms", alarms},
                                             {"expected_alarms", options.level * comparisons}});
}

}  // namespace tools
