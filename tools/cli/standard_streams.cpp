#include "tools/cli/standard_streams.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <memory>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "tools/cli/interrupt.h"
#include "tools/cli/outline.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/files/output.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

constexpr const char* kStreamWord = "-";
constexpr const char* kTakesStdin = "; - is stdin";  // in an option's help

/// The options of one command line that have taken the streams; empty names where none has.
struct TakenStreams {
  std::string input;
  std::string output;
  std::uintmax_t max_input_bytes = vo::kMaxFileBytes;
};

/// Reads stdin to its end and puts a file of what came in its place.
void hold_stdin(std::uintmax_t max_bytes) {
  const int flags = ::fcntl(STDIN_FILENO, F_GETFL);
  vo::require(flags >= 0 && (flags & O_ACCMODE) != O_WRONLY, vo::kStdinPath,
              ": is closed or cannot be read, expected a file or pipe");
  const int held = ::memfd_create("stdin", MFD_CLOEXEC);
  if (held < 0) {
    vo::fail_with(vo::kStdinPath, "cannot be held", errno);
  }
  try {
    vo::copy_stream(STDIN_FILENO, held, vo::kStdinPath, max_bytes, throw_if_interrupted);
  } catch (const vo::Error&) {
    ::close(held);
    throw;
  }
  const int stream = ::dup2(held, STDIN_FILENO);
  ::close(held);
  if (stream < 0) {
    vo::fail_with(vo::kStdinPath, "cannot be held", errno);
  }
}

/// Lets an option take `-` for the stream `path`, once for all that share `taken`.
void take_stream(CLI::Option& option, const char* path,
                 const std::function<std::string&()>& taken) {
  const std::string name = option.get_name();
  option.transform([name, path, taken](std::string word) -> std::string {
    if (word != kStreamWord) {
      return word;
    }
    if (std::string& first = taken(); !first.empty()) {
      vo::fail_as(vo::ErrorKind::usage, name, ": ", path, " is taken by ", first,
                  " already, expected at most one -");
    } else {
      first = name;
    }
    return path;
  });
}

void refuse_stream(CLI::Option& option) {
  const std::string name = option.get_name();
  option.transform([name](std::string word) -> std::string {
    if (word == kStreamWord) {
      vo::fail_as(vo::ErrorKind::usage, name,
                  ": - stands for a stream, which cannot be used here; ./- is a name");
    }
    return word;
  });
}

void add_to_help(CLI::Option& option, const char* text) {
  option.description(option.get_description() + text);
}

/// Throws where `--json`, which prints on stdout, is given together with an output there.
void require_one_output(const CLI::App& command, const TakenStreams& taken) {
  const CLI::Option* json = find_option(command, "--json");
  const bool is_flag = json != nullptr && json->get_items_expected_max() == 0;
  if (is_flag && json->count() > 0 && !taken.output.empty()) {
    vo::fail_as(vo::ErrorKind::usage, "--json: ", vo::kStdoutPath, " is taken by ", taken.output,
                " already, expected at most one of both");
  }
}

/// Throws where two of the options name one file, in whatever way.
void require_distinct_outputs(const CLI::App& command, const std::vector<std::string>& outputs) {
  std::map<std::filesystem::path, std::string> writers;
  for (const std::string& name : outputs) {
    for (const std::string& word : find_option(command, name)->results()) {
      if (vo::is_stream(word)) {
        continue;
      }
      const auto [first, is_new] = writers.try_emplace(vo::resolved_output(word), name);
      if (!is_new && first->second != name) {
        vo::fail_as(vo::ErrorKind::usage, name, ": ", word, " is written by ", first->second,
                    " already, expected another file");
      }
    }
  }
}

}  // namespace

void take_streams(CLI::App& command, const FileArguments& files) {
  const auto taken = std::make_shared<TakenStreams>();
  for (const std::string& name : files.inputs) {
    CLI::Option& option = *find_option(command, name);
    take_stream(option, vo::kStdinPath, [taken]() -> std::string& { return taken->input; });
    add_to_help(option, kTakesStdin);
  }
  for (const std::string& name : files.configurations) {
    CLI::Option& option = *find_option(command, name);
    take_stream(option, vo::kStdinPath, [taken]() -> std::string& {
      taken->max_input_bytes = vo::kMaxConfigurationBytes;
      return taken->input;
    });
    add_to_help(option, kTakesStdin);
  }
  for (const std::string& name : files.outputs) {
    CLI::Option& option = *find_option(command, name);
    take_stream(option, vo::kStdoutPath, [taken]() -> std::string& { return taken->output; });
    add_to_help(option, "; - is stdout");
  }
  for (const std::string& name : files.others) {
    refuse_stream(*find_option(command, name));
  }
  command.parse_complete_callback([&command, taken, outputs = files.outputs] {
    require_one_output(command, *taken);
    require_distinct_outputs(command, outputs);
    if (!taken->input.empty()) {
      hold_stdin(taken->max_input_bytes);
    }
  });
}

void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) {
      // The lowest number that is free is this stream's: those below have been filled.
      ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

Speech speech_beside(const Session& session, const std::vector<std::filesystem::path>& outputs) {
  const bool is_taken = std::any_of(outputs.begin(), outputs.end(),
                                    [](const auto& path) { return path == vo::kStdoutPath; });
  return is_taken ? Speech{std::cerr, session.err} : Speech{std::cout, session.out};
}

}  // namespace tools
