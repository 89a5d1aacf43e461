#include "tools/scenario/error_titles.h"

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {

std::string alignment_text(vo::TrajectoryAlignment alignment) {
  switch (alignment) {
    case vo::TrajectoryAlignment::none:
      return "not aligned";
    case vo::TrajectoryAlignment::se3:
      return "aligned by SE(3)";
    case vo::TrajectoryAlignment::sim3:
      break;
  }
  return "aligned by Sim(3)";
}

std::string ate_title(const std::string& unit, vo::TrajectoryAlignment alignment) {
  return vo::concat("ATE, ", unit, ", ", alignment_text(alignment));
}

std::string rpe_title(const std::string& unit, double interval) {
  return vo::concat("RPE over ", vo::format_real(interval), " s, ", unit);
}

}  // namespace tools
