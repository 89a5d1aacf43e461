#include "tools/datasets/plan_file.h"

#include "tools/datasets/layout.h"
#include "tools/datasets/sealed_document.h"
#include "vo/core/error.h"
#include "vo/hashing/content_hash.h"

namespace tools {
namespace {

using PlanJson = nlohmann::ordered_json;

constexpr JsonSchema kPlanSchema{"dataset_plan"};
constexpr const char* kAnew =
    "; expected another --out, or its folder removed, to begin the data set anew";

PlanJson plan_document(const DatasetSpec& spec, const DatasetPlan& plan) {
  PlanJson sequences = PlanJson::array();
  for (std::size_t i = 0; i < spec.sequences.size(); ++i) {
    sequences.push_back({{"name", spec.sequences[i].name},
                         {"split", spec.sequences[i].split},
                         {"frames", plan.frames[i]}});
  }
  PlanJson rejected = PlanJson::array();
  for (const RejectedSequence& sequence : plan.rejected) {
    rejected.push_back({{"name", sequence.name}, {"reason", sequence.reason}});
  }
  PlanJson parts = PlanJson::array();
  for (const DatasetPart& part : plan.parts) {
    parts.push_back({part.sequence, part.number, part.first, part.end});
  }
  PlanJson members = {{"name", spec.options.name}, {"identity", plan.identity}};
  if (spec.rig) {
    members["cameras"] = plan.cameras;
  }
  members["sequences"] = sequences;
  members["rejected"] = rejected;
  members["parts"] = parts;
  return json_document(kPlanSchema, members);
}

/// Returns a whole number of at least 0. Throws vo::Error beginning with `place` for all else.
std::size_t count_of(const PlanJson& value, const std::string& place) {
  vo::require(value.is_number_unsigned(), place, ": got ", value.dump(),
              ", expected a whole number of at least 0");
  return value.get<std::size_t>();
}

DatasetPlan plan_of(const PlanJson& document, const std::string& place) {
  DatasetPlan plan;
  document.at("identity").get_to(plan.identity);
  if (document.contains("cameras")) {
    plan.cameras = count_of(document.at("cameras"), place + ": cameras");
  }
  for (const PlanJson& sequence : document.at("sequences")) {
    plan.frames.push_back(count_of(sequence.at("frames"), place + ": sequences: frames"));
  }
  for (const PlanJson& sequence : document.at("rejected")) {
    plan.rejected.push_back({sequence.at("name"), sequence.at("reason")});
  }
  const std::string of_part = place + ": parts";
  for (const PlanJson& part : document.at("parts")) {
    plan.parts.push_back({count_of(part.at(0), of_part), count_of(part.at(1), of_part),
                          count_of(part.at(2), of_part), count_of(part.at(3), of_part)});
  }
  return plan;
}

}  // namespace

std::string format_plan(const DatasetSpec& spec, const DatasetPlan& plan) {
  return json_text(plan_document(spec, plan), -1);
}

std::string format_sealed_plan(const DatasetSpec& spec, const DatasetPlan& plan) {
  return sealed_text(plan_document(spec, plan));
}

std::string plan_hash(const DatasetSpec& spec, const DatasetPlan& plan) {
  return vo::content_hash(format_plan(spec, plan));
}

DatasetPlan read_plan(const std::filesystem::path& file) {
  const PlanJson document = read_document(file, kPlanSchema);
  if (!has_seal(document)) {
    vo::fail_as(vo::ErrorKind::output_exists, file.string(),
                ": was written by an earlier edvo, without a hash", kAnew);
  }
  vo::require(is_as_sealed(document), file.string(), ": is not as it was written: its hash differs",
              kAnew);
  try {
    return plan_of(document, file.string());
  } catch (const nlohmann::json::exception& error) {
    vo::fail(file.string(), ": no plan of a data set: ", error.what());
  }
}

}  // namespace tools
