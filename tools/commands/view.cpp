#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "tools/cli/exit_code.h"
#include "tools/cli/live_arguments.h"
#include "tools/cli/options.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/watched_run.h"
#include "tools/commands/commands.h"
#include "tools/live/live_server.h"
#include "vo/core/error.h"
#include "vo/files/input.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kViewHelp =
    "Shows on a page of this machine what is done: the report of a folder that `edvo run` made, "
    "or\n"
    "a report that `edvo test --report` wrote. The page's URL is on stderr; who does not know it\n"
    "sees nothing, and nothing can be changed there. Ctrl-C ends it (exit code 130).\n"
    "For a run that is not yet done see --live of track, render, run and test.";

constexpr const char* kViewExamples =
    "Examples:\n"
    "  edvo view build/room_tour\n"
    "  edvo view report.html --port 8080";

struct ViewArguments {
  std::string result;
  LiveArguments live;
};

/// Returns the report that a folder holds, or the file itself. Throws vo::Error where it is none.
std::string report_of(const std::string& result) {
  constexpr const char* kTitle = "<title>edvo report";
  const fs::path given = result;
  const fs::path file = fs::is_directory(given) ? given / "report.html" : given;
  vo::require(fs::exists(file), given.string(),
              fs::is_directory(given) ? ": has no report.html" : ": there is no such file",
              ", expected a folder that `edvo run` made, or a report");
  std::string page = vo::read_file(file);
  vo::require(page.find(kTitle) != std::string::npos, file.string(),
              ": is no report of edvo's, expected one of `edvo run` or `edvo test --report`");
  return page;
}

void view(const ViewArguments& arguments, Session& session) {
  const LiveServer server({.page = report_of(arguments.result)}, arguments.live.chosen_port());
  std::cerr << server.url() << "\n";
  wait_for_interrupt();
  session.status = exit_code::kInterrupted;
}

}  // namespace

void add_view_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("view", kViewHelp);
  const auto arguments = std::make_shared<ViewArguments>();
  command.footer(kViewExamples);
  command.add_option("RESULT", arguments->result, "folder of `edvo run`, or a report.html")
      ->required();
  command.add_option("--port", arguments->live.port, "of the page; 0 is any that is free [0]");
  take_streams(command, {.others = {"RESULT"}});
  command.callback([arguments, &session] { view(*arguments, session); });
}

}  // namespace tools
