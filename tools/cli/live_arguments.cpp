#include "tools/cli/live_arguments.h"

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

constexpr const char* kFlag = "true";  // what CLI11 says of a flag without a value

}  // namespace

int LiveArguments::chosen_port() const {
  constexpr int kLast = 65535;
  if (port.empty() || port == kFlag) {
    return 0;
  }
  try {
    const auto number = vo::parse_integer(port);
    vo::require(number >= 0 && number <= kLast, "out of range");
    return static_cast<int>(number);
  } catch (const vo::Error&) {
    vo::fail_as(vo::ErrorKind::usage, port_option, port, ": expected a port, 0 to ", kLast,
                "; 0 is any that is free");
  }
}

void add_live_options(CLI::App& command, LiveArguments& arguments) {
  command
      .add_flag("--live", arguments.port,
                "show the run on a page of this machine while it runs; its URL is on\n"
                "stderr. --live=PORT chooses the port")
      ->group("Live");
  command
      .add_flag("--live-keep", arguments.keep,
                "--live, and the page stays until Ctrl-C when the run is over")
      ->group("Live");
  command
      .add_flag("--live-paused", arguments.paused,
                "--live, and the run waits after its first frame until the page lets it go on")
      ->group("Live");
}

}  // namespace tools
