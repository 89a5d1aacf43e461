#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace tools {

/// The options of commands whose run can be watched on a page.
struct LiveArguments {
  std::string port;                     ///< of --live; empty without it
  std::string port_option = "--live=";  ///< what precedes the port on the command line
  bool keep = false;                    ///< whether the page stays when the run is over
  bool paused = false;                  ///< whether the run waits for its viewer

  bool is_asked() const { return !port.empty() || keep || paused; }
  int chosen_port() const;  ///< 0 is any that is free; throws vo::Error of kind usage
};

void add_live_options(CLI::App& command, LiveArguments& arguments);

}  // namespace tools
