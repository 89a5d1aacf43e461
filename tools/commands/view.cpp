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
#include "tools/live/event_feed.h"
#include "tools/live/live_server.h"
#include "tools/watch/finished_track.h"
#include "tools/watch/watch_page.h"
#include "vo/core/error.h"
#include "vo/files/input.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kViewHelp =
    "Shows on a page of this machine what is done: the report of a folder that `edvo run` made, "
    "or\n"
    "a report that `edvo test --report` wrote; or a trajectory that `edvo track` wrote, in the "
    "page of\n"
    "--live, with what lies beside it of e.txt: e.csv (--frame-log), e_times.csv (--time-log) and\n"
    "e_panels (--debug-images). Trajectories of other programs are shown without those. The page's "
    "URL is on stderr; who does not know it\n"
    "sees nothing, and nothing can be changed there. Ctrl-C ends it (exit code 130).\n"
    "For a run that is not yet done see --live of track, render, run and test.";

constexpr const char* kViewExamples =
    "Examples:\n"
    "  edvo view build/room_tour\n"
    "  edvo view report.html --port 8080\n"
    "  edvo track sequence --out e.txt --frame-log e.csv --time-log e_times.csv --debug-images 5\n"
    "  edvo view e.txt";

struct ViewArguments {
  std::string result;
  std::string frame_log;
  std::string time_log;
  std::string panels;
  LiveArguments live;
};

bool names_report(const fs::path& result) {
  return fs::is_directory(result) || result.extension() == ".html";
}

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

/// Returns the track that a trajectory is of. Throws vo::Error where it is none.
FinishedTrack track_of(const ViewArguments& arguments) {
  vo::require(fs::exists(arguments.result), arguments.result, ": there is no such file",
              ", expected a folder that `edvo run` made, a report, or a trajectory");
  return read_finished_track(with_files_beside({.trajectory = arguments.result,
                                                .frame_log = arguments.frame_log,
                                                .time_log = arguments.time_log,
                                                .panels = arguments.panels}));
}

void serve(const LiveContent& content, const LiveArguments& live, Session& session) {
  const LiveServer server(content, {live.chosen_port(), live.port_option});
  std::cerr << server.url() << "\n";
  wait_for_interrupt();
  session.status = exit_code::kInterrupted;
}

void view(const ViewArguments& arguments, Session& session) {
  if (!names_report(arguments.result)) {
    EventFeed feed;
    tell(track_of(arguments), feed);
    serve({.page = watch_page(), .feed = &feed}, arguments.live, session);
    return;
  }
  for (const std::string& file : {arguments.frame_log, arguments.time_log, arguments.panels}) {
    if (!file.empty()) {
      vo::fail_as(vo::ErrorKind::usage, file, ": expected a trajectory with it, not ",
                  arguments.result);
    }
  }
  serve({.page = report_of(arguments.result)}, arguments.live, session);
}

}  // namespace

void add_view_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("view", kViewHelp);
  const auto arguments = std::make_shared<ViewArguments>();
  arguments->live.port_option = "--port ";
  command.footer(kViewExamples);
  command
      .add_option("RESULT", arguments->result,
                  "folder of `edvo run`, a report.html, or a trajectory")
      ->required();
  command.add_option("--frame-log", arguments->frame_log, "of the trajectory [beside it: e.csv]");
  command.add_option("--time-log", arguments->time_log, "of the trajectory [e_times.csv]");
  command.add_option("--panels", arguments->panels, "folder of pictures [e_panels]");
  command.add_option("--port", arguments->live.port, "of the page; 0 is any that is free [0]");
  take_streams(command, {.read = {"RESULT", "--frame-log", "--time-log", "--panels"}});
  command.callback([arguments, &session] { view(*arguments, session); });
}

}  // namespace tools
