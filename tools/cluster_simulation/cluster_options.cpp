#include "tools/cluster_simulation/cluster_options.h"

#include <initializer_list>
#include <sstream>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

void set_option(const std::string& assignment, std::vector<vo::Field>& fields) {
  const std::size_t equals = assignment.find('=');
  vo::require(equals != std::string::npos, "expected key=value,key=value, got '", assignment, "'");
  vo::set_field(fields, assignment.substr(0, equals), assignment.substr(equals + 1));
}

}  // namespace

void ClusterOptions::validate() const {
  constexpr int kMost = 10'000'000;
  constexpr double kLargest = 1e12;
  vo::require(nodes >= 1 && nodes <= kMost, "nodes: expected 1 to ", kMost, ", got ", nodes);
  vo::require(processors >= 1 && processors <= kMost / nodes, "processors: expected 1 to ",
              kMost / nodes, " per node, got ", processors);
  vo::require(task_processors >= 1 && task_processors <= processors,
              "task_processors: expected 1 to ", processors, ", got ", task_processors);
  vo::require(task_parts >= 1, "task_parts: expected at least 1, got ", task_parts);
  ClusterOptions copy = *this;
  for (const vo::Field& field : vo::fields_of(copy)) {
    if (field.type == vo::FieldType::real) {
      const double value = vo::parse_real(field.get());
      vo::require(value >= 0 && value <= kLargest, field.key, ": expected 0 to ", kLargest,
                  ", got ", field.get());
    }
  }
  vo::require(frame_s + write_s > 0, "frame_s: expected above 0 unless write_s is");
}

void set_cluster_options(const std::string& text, ClusterOptions& options) {
  std::vector<vo::Field> fields = vo::fields_of(options);
  try {
    std::istringstream assignments(text);
    for (std::string assignment; std::getline(assignments, assignment, ',');) {
      set_option(assignment, fields);
    }
    options.validate();
  } catch (const vo::Error& error) {
    vo::fail_as(vo::ErrorKind::usage, "--simulate: ", error.what());
  }
}

}  // namespace tools
