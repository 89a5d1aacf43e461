#include "tools/studies/imperfections.h"

#include <algorithm>
#include <string_view>

#include "vo/core/fields.h"

namespace tools {
namespace {

constexpr std::string_view kSensor = "sensor.";
constexpr std::string_view kDistortion = "camera.distortion.";

/// Returns the imperfection of an option: that of `sensor.depth.holes.max_step` is `depth.holes`.
/// It is empty for other options.
std::string imperfection_of(const std::string& key) {
  if (key.starts_with(kDistortion)) {
    return "distortion";
  }
  if (!key.starts_with(kSensor) || key.ends_with("seed") || key.ends_with("preset")) {
    return "";
  }
  const std::string rest = key.substr(kSensor.size());
  return rest.substr(0, rest.rfind('.'));
}

}  // namespace

std::vector<Imperfection> find_imperfections(const Scenario& scenario) {
  Scenario actual = scenario;
  Scenario perfect;
  const std::vector<vo::Field> fields = vo::fields_of(actual);
  const std::vector<vo::Field> defaults = vo::fields_of(perfect);
  std::vector<Imperfection> found;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string name = imperfection_of(fields[i].key);
    if (name.empty() || fields[i].get() == defaults[i].get()) {
      continue;
    }
    auto place = std::find_if(found.begin(), found.end(),
                              [&](const Imperfection& known) { return known.name == name; });
    if (place == found.end()) {
      place = found.insert(found.end(), {name, {}});
    }
    place->off.emplace_back(fields[i].key, defaults[i].get());
  }
  return found;
}

Scenario without(const Scenario& scenario, const std::vector<Imperfection>& imperfections) {
  Scenario result = scenario;
  std::vector<vo::Field> fields = vo::fields_of(result);
  for (const Imperfection& imperfection : imperfections) {
    for (const auto& [key, value] : imperfection.off) {
      vo::set_field(fields, key, value);
    }
  }
  return result;
}

}  // namespace tools
