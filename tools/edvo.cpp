#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <malloc.h>
#include <opencv2/core/utility.hpp>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/session.h"
#include "tools/cli/spelling.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "vo/core/error.h"
#include "vo/core/instruction_set.h"
#include "vo/core/version.h"
#include "vo/files/system_failure.h"

namespace {

constexpr const char* kDescription =
    "Edge-direct visual odometry and its synthetic RGB-D laboratory.\n\n"
    "  edvo inspect      what a glTF scene holds\n"
    "  edvo render       a glTF scene and a camera path -> an RGB-D sequence with exact poses\n"
    "  edvo path         what a camera path does in a scene: clearance, speed, flow, blank views\n"
    "  edvo convert      an RGB-D sequence -> TUM, EuRoC or ICL-NUIM\n"
    "  edvo record       an RGB-D camera that runs -> a sequence\n"
    "  edvo track        an RGB-D sequence -> a trajectory\n"
    "  edvo evaluate     two trajectories -> their errors\n"
    "  edvo run          a scenario: all three, and a verdict\n"
    "  edvo view         a page that shows what a run has made; --live shows it meanwhile\n"
    "  edvo depth        monocular mapping alone: an inverse-depth map beside the truth\n"
    "  edvo test         many scenarios: did a tracker, ours or another, get worse?\n"
    "  edvo compare      two results or builds, with statistics\n"
    "  edvo budget       which imperfection of the camera causes what share of the error\n"
    "  edvo basin        from how far off the truth an alignment finds it\n"
    "  edvo dataset      many sequences that one file describes, made by many processes\n"
    "  edvo sweep        any options of scenarios as a table and plot\n"
    "  edvo submit       a data set or scenarios in shares, by Slurm or GNU parallel\n"
    "  edvo cache        the sequences that are kept for tests\n"
    "  edvo train-edges  glTF scenes -> a learnt edge detector, or a detector's precision\n"
    "  edvo sensor-check the noise of the sensor presets beside their formulas\n"
    "  edvo bench        ms per frame, ours beside others\n"
    "  edvo bench-render CPU s per rendered frame, and how it grows\n"
    "  edvo ablate       the paper's experiments on a sequence or scenario\n"
    "  edvo completion   what a shell completes; edvo manual: pages for man\n\n"
    "`edvo help COMMAND` explains each with examples.";

constexpr const char* kFooter =
    "Exit codes: 0 ok, 1 internal error, 2 wrong command line, 3 unusable input or output place,\n"
    "4 a bound was violated, 5 tracking was lost, 6 the output exists and differs (--force),\n"
    "75 try again (disk full, too many files, no memory, terminated), 130 interrupted;\n"
    "a second signal, half a second after the first or later, ends the program at once;\n"
    "nobody reads stdout: ended by SIGPIPE, which a shell shows as 141.";

int run(std::vector<std::string> words, tools::Session& session) {
  CLI::App program(kDescription, "edvo");
  program.footer(kFooter);
  program.set_version_flag("--version", std::string("edvo ") + vo::version());
  program.require_subcommand(1);
  tools::add_inspect_command(program, session);
  tools::add_render_command(program, session);
  tools::add_path_command(program, session);
  tools::add_convert_command(program, session);
  tools::add_record_command(program, session);
  tools::add_track_command(program, session);
  tools::add_evaluate_command(program, session);
  tools::add_run_command(program, session);
  tools::add_depth_command(program, session);
  tools::add_bench_command(program, session);
  tools::add_bench_render_command(program, session);
  tools::add_ablate_command(program, session);
  tools::add_sensor_check_command(program, session);
  tools::add_train_edges_command(program, session);
  tools::add_test_command(program, session);
  tools::add_dataset_command(program, session);
  tools::add_cache_command(program, session);
  tools::add_submit_command(program, session);
  tools::add_compare_command(program, session);
  tools::add_budget_command(program, session);
  tools::add_basin_command(program, session);
  tools::add_sweep_command(program, session);
  tools::add_view_command(program, session);
  tools::add_completion_command(program, session);
  tools::add_manual_command(program, session);
  tools::add_colour_option(program);
  tools::refuse_empty_values(program);
  program.failure_message([&](const CLI::App* app, const CLI::Error& error) {
    return tools::error_text(session.err, CLI::FailureMessage::simple(app, error));
  });
  words = tools::without_help_command(std::move(words));
  tools::require_known_words(program, words);
  words = tools::without_json_place(program, std::move(words));
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    program.parse(words);
  } catch (const CLI::ParseError& error) {
    // A help that was asked for is a result like any other.
    session.status = program.exit(error) == 0 ? tools::exit_code::kOk : tools::exit_code::kUsage;
  }
  if (!std::cout.flush()) {
    vo::fail_as(vo::ErrorKind::temporary, "the result cannot be written to stdout");
  }
  return session.status;
}

/// Every frame needs images of the same sizes: what one gives back is not returned to the system,
/// which would hand it out again page by page, each cleared.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kLargestBlock = 32 << 20;    // bytes, the most that glibc takes
  mallopt(M_MMAP_THRESHOLD, kLargestBlock);  // NOLINT(concurrency-mt-unsafe): no threads yet
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());  // NOLINT(concurrency-mt-unsafe)
#endif
}

/// Ends the process as where memory ends elsewhere, if that is why an exception was not caught: a
/// library that is loaded throws it before any of its functions can be called, or a thread of its.
[[noreturn]] void end_uncaught() {
  try {
    if (const std::exception_ptr uncaught = std::current_exception()) {
      std::rethrow_exception(uncaught);
    }
  } catch (const std::bad_alloc&) {
    std::fputs("edvo: out of memory\n", stderr);
    std::_Exit(tools::exit_code::kTemporary);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "edvo: internal error: %s\n", error.what());
  }
  std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  tools::fill_closed_streams();
  const std::vector<std::string> words(argv + 1, argv + argc);
  tools::Session session = tools::start_session(words);
  const auto fail = [&](const std::string& text, int code) {
    std::cerr << tools::error_line(session.err, text);
    return code;
  };
  try {
    std::set_terminate(end_uncaught);
    tools::remember_signals();
    cv::setNumThreads(1);
    keep_freed_memory();
    vo::available_instruction_set();  // a name in the environment that is none ends here
    return run(words, session);
  } catch (const vo::Error& error) {
    return fail(error.what(), tools::exit_code::of(error.kind()));
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(error.path1().string() + ": " + error.code().message(),
                tools::exit_code::of(vo::kind_of_failure(error.code().value())));
  } catch (const cv::Exception& error) {
    const bool is_memory = error.code == cv::Error::StsNoMem;
    return fail((is_memory ? "out of memory: " : "internal error: ") + error.err,
                is_memory ? tools::exit_code::kTemporary : tools::exit_code::kInternalError);
  } catch (const std::system_error& error) {
    const bool is_scarce = error.code() == std::errc::resource_unavailable_try_again;
    return fail(std::string(is_scarce ? "no memory for another thread: " : "internal error: ") +
                    error.what(),
                is_scarce ? tools::exit_code::kTemporary : tools::exit_code::kInternalError);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", tools::exit_code::kTemporary);
  } catch (const std::exception& error) {
    return fail(std::string("internal error: ") + error.what(), tools::exit_code::kInternalError);
  }
}
