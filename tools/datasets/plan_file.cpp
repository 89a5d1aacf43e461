#include "tools/datasets/plan_file.h"

#include <nlohmann/json.hpp>

#include "tools/datasets/layout.h"
#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/hashing/content_hash.h"
#include "vo/text_files/json_limits.h"

namespace tools {

std::string format_plan(const DatasetSpec& spec, const DatasetPlan& plan) {
  nlohmann::ordered_json sequences = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < spec.sequences.size(); ++i) {
    sequences.push_back({{"name", spec.sequences[i].name},
                         {"split", spec.sequences[i].split},
                         {"frames", plan.frames[i]}});
  }
  nlohmann::ordered_json rejected = nlohmann::ordered_json::array();
  for (const RejectedSequence& sequence : plan.rejected) {
    rejected.push_back({{"name", sequence.name}, {"reason", sequence.reason}});
  }
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for (const DatasetPart& part : plan.parts) {
    parts.push_back({part.sequence, part.number, part.first, part.end});
  }
  nlohmann::ordered_json members = {{"name", spec.options.name}, {"identity", plan.identity}};
  if (spec.rig) {
    members["cameras"] = plan.cameras;
  }
  members["sequences"] = sequences;
  members["rejected"] = rejected;
  members["parts"] = parts;
  return json_text(json_document({"dataset_plan"}, members), -1);
}

std::string plan_hash(const DatasetSpec& spec, const DatasetPlan& plan) {
  return vo::content_hash(format_plan(spec, plan));
}

DatasetPlan read_plan(const std::filesystem::path& file) {
  const std::string text = vo::read_file(file, vo::kMaxDocumentBytes);
  vo::require_json_within_limits(text, file.string());
  DatasetPlan plan;
  try {
    const nlohmann::json document = nlohmann::json::parse(text);
    document.at("identity").get_to(plan.identity);
    plan.cameras = document.value("cameras", plan.cameras);
    vo::require(plan.cameras >= 1, file.string(), ": cameras: expected at least 1");
    for (const nlohmann::json& sequence : document.at("sequences")) {
      plan.frames.push_back(sequence.at("frames").get<std::size_t>());
    }
    for (const nlohmann::json& sequence : document.at("rejected")) {
      plan.rejected.push_back({sequence.at("name"), sequence.at("reason")});
    }
    for (const nlohmann::json& part : document.at("parts")) {
      plan.parts.push_back({part.at(0), part.at(1), part.at(2), part.at(3)});
      vo::require(plan.parts.back().sequence < plan.frames.size() &&
                      plan.parts.back().first < plan.parts.back().end &&
                      plan.parts.back().end <= plan.frames[plan.parts.back().sequence],
                  file.string(), ": a part without frames");
    }
  } catch (const nlohmann::json::exception& error) {
    vo::fail(file.string(), ": no plan of a data set: ", error.what());
  }
  return plan;
}

}  // namespace tools
