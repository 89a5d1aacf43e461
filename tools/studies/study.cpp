#include "tools/studies/study.h"

#include <nlohmann/json.hpp>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

std::string as_markdown(const StudyReport& report, const std::string& command) {
  std::string text = vo::concat("# ", report.title, "\n\n", report.method, "\n\n![", report.title,
                                "](", report.name, ".svg)\n\n", as_markdown(report.table), "\n");
  for (const std::string& finding : report.findings) {
    text += "- " + finding + "\n";
  }
  return text + "\nRepeat with `" + command + "`.\n";
}

}  // namespace

void StudySettings::validate() const {
  vo::require(seeds >= 1, "--seeds: expected at least 1, got ", seeds);
  vo::require(max_error > 0 && max_error_deg > 0,
              "--max-error, --max-error-deg: expected above 0, got ", max_error, " and ",
              max_error_deg);
}

std::string StudySettings::described() const {
  std::string text = vo::concat("preset ", vo::to_string(preset));
  const char* separator = " with ";
  for (const auto& [key, value] : assignments) {
    text += vo::concat(separator, key, "=", value);
    separator = ", ";
  }
  return text;
}

bool StudySettings::accepts(const PoseError& error) const {
  return error.mm < kMmPerM * max_error && error.deg < max_error_deg;
}

vo::TrackerOptions StudySettings::options(const Assignments& held,
                                          const Assignments& varied) const {
  vo::TrackerOptions options = vo::preset_options(preset);
  std::vector<vo::Field> fields = vo::fields_of(options);
  for (const Assignments* part : {&held, &assignments, &varied}) {
    for (const auto& [key, value] : *part) {
      vo::set_field(fields, key, value);
    }
  }
  options.validate();
  return options;
}

vo::MonoOptions StudySettings::mono_options(const Assignments& varied) const {
  vo::MonoOptions options = vo::mono_options();
  options.bootstrap = vo::MonoBootstrap::rgbd;
  std::vector<vo::Field> fields = vo::fields_of(options);
  for (const Assignments* part : {&assignments, &varied}) {
    for (const auto& [key, value] : *part) {
      vo::set_field(fields, key, value);
    }
  }
  options.validate();
  return options;
}

std::vector<vo::NamedBytes> study_files(const StudyReport& report, const std::string& command) {
  std::vector<vo::NamedBytes> files = {{report.name + ".csv", as_csv(report.table)},
                                       {report.name + ".svg", report.plot},
                                       {report.name + ".md", as_markdown(report, command)}};
  files.insert(files.end(), report.more.begin(), report.more.end());
  return files;
}

std::string as_text(const StudyReport& report) {
  std::string text = report.title + "\n\n" + as_text(report.table) + "\n";
  for (const std::string& finding : report.findings) {
    text += finding + "\n";
  }
  return text;
}

nlohmann::ordered_json as_json(const StudyReport& report) {
  return {{"study", report.name},
          {"title", report.title},
          {"rows", as_json(report.table)},
          {"findings", report.findings}};
}

}  // namespace tools
