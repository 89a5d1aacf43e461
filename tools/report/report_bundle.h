#pragma once

#include <string_view>

namespace tools {

/// Interactive part of the HTML report, bundled from web/ when the program was built.
struct ReportBundle {
  std::string_view script;   ///< JavaScript
  std::string_view style;    ///< CSS
  std::string_view missing;  ///< why there is no bundle; empty if there is one
};

ReportBundle report_bundle();

}  // namespace tools
