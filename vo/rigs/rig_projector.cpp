#include "vo/rigs/rig_projector.h"

#include <algorithm>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/rigs/rig_pose.h"

namespace vo {
namespace {

constexpr const char* kDots = "dots.";

std::vector<Field> dots_fields(RandomDots& dots) {
  std::vector<Field> fields;
  FieldCollector collect(fields, kDots);
  collect("number", dots.number, "of dots");
  collect("diameter_deg", dots.diameter_deg,
          "of a dot on the optical axis, at half its brightness");
  collect("seed", dots.seed, "of their places");
  return fields;
}

void validate_dots(const RandomDots& dots, const std::string& place) {
  constexpr int kMostDots = 1'000'000;
  constexpr double kMaxDiameter = 45;  // deg
  require(dots.number >= 1 && dots.number <= kMostDots, place,
          ": dots.number: expected a number from 1 to ", kMostDots, ", got ", dots.number);
  require(dots.diameter_deg > 0 && dots.diameter_deg <= kMaxDiameter, place,
          ": dots.diameter_deg: expected an angle above 0 and up to ", kMaxDiameter, " deg, got ",
          format_real(dots.diameter_deg));
}

void validate_projector(const RigProjector& projector) {
  constexpr double kMinFov = 1;      // deg
  constexpr double kMaxFov = 170;    // deg
  constexpr double kMaxPower = 1e9;  // cd; pictures are computed in 32-bit floats
  const std::string place = describe(projector);
  for (const double fov : projector.fov_deg) {
    require(fov >= kMinFov && fov <= kMaxFov, place,
            ": fov_deg: expected two angles, horizontal and vertical, from ", kMinFov, " to ",
            kMaxFov, " deg, got ", format_real(fov));
  }
  require(projector.power >= 0 && projector.power <= kMaxPower, place,
          ": power: expected a radiant intensity from 0 to ", format_real(kMaxPower), ", got ",
          format_real(projector.power));
  require(!projector.has_file() || projector.file().extension() == ".png", place, ": pattern: is ",
          quoted_toml(projector.pattern), ", expected ", quoted_toml(kRandomDots),
          " or a PNG file, whose name ends with .png");
  validate_dots(projector.dots, place);
}

/// Throws Error if options of random dots are given beside the pattern of a file.
void require_one_pattern(const TomlRecord& record, const RigProjector& projector) {
  const bool has_dots =
      std::any_of(record.values.begin(), record.values.end(),
                  [](const TomlValue& value) { return value.key.starts_with(kDots); });
  require(!projector.has_file() || !has_dots, describe(projector),
          ": dots: are for pattern = ", quoted_toml(kRandomDots), ", got the pattern ",
          quoted_toml(projector.pattern));
}

}  // namespace

RigProjector read_rig_projector(const TomlRecord& record, const std::filesystem::path& folder) {
  RigProjector result;
  result.place = record.place;
  result.folder = folder;
  PoseValues pose;
  std::vector<double> fov_deg;
  std::vector<Field> fields = dots_fields(result.dots);
  FieldCollector collect(fields, "");
  collect("name", result.name, "of the projector");
  collect("power", result.power, "radiant intensity at the pattern's white");
  collect("pattern", result.pattern, "random_dots, or a PNG file");
  fields.push_back(numbers_field("fov_deg", "of the pattern, horizontal and vertical", 2, fov_deg));
  add_pose_fields("", "T_body_projector", pose, fields);
  assign_fields(record.values, fields);
  require(!result.name.empty(), result.place, ": [[projector]]: expected a name");
  require(is_plain_name(result.name), describe(result),
          ": expected a name of letters, digits, '-' and '_'");
  require(!fov_deg.empty(), describe(result),
          ": expected fov_deg, the pattern's horizontal and vertical field of view");
  result.fov_deg = {fov_deg[0], fov_deg[1]};
  result.T_body_projector = pose_of(describe(result), "T_body_projector", pose);
  validate_projector(result);
  require_one_pattern(record, result);
  return result;
}

std::string format_rig_projector(const RigProjector& projector) {
  RandomDots dots = projector.dots;
  return concat("\n[[projector]]\nname = ", quoted_toml(projector.name), "\n",
                format_pose("T_body_projector", projector.T_body_projector), "fov_deg = [",
                format_real(projector.fov_deg.x()), ", ", format_real(projector.fov_deg.y()), "]\n",
                format_toml(TomlValue{"power", format_real(projector.power), FieldType::real, ""}),
                "pattern = ", quoted_toml(projector.pattern), "\n",
                projector.has_file() ? std::string() : format_toml(dots_fields(dots)));
}

}  // namespace vo
