#include "tools/cli/standard_streams.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <string_view>
#include <system_error>

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

/// Adds the files and folders that the options of these names were given.
void add_places_of(const CLI::App& command, const std::vector<std::string>& names,
                   std::vector<NamedPlace>& places) {
  for (const std::string& name : names) {
    for (const std::string& word : find_option(command, name)->results()) {
      if (!word.empty()) {
        places.push_back({name, word});
      }
    }
  }
}

/// Returns all files and folders that are read and are there, streams left out. What is not there
/// is a preset, or fails when it is read.
std::vector<NamedPlace> read_places(const CLI::App& command, const FileArguments& files) {
  std::vector<NamedPlace> places;
  add_places_of(command, files.inputs, places);
  add_places_of(command, files.configurations, places);
  add_places_of(command, files.read, places);
  for (const NamedPlace& place : files.defaults) {
    if (find_option(command, place.name)->count() == 0) {
      places.push_back(place);
    }
  }
  std::erase_if(places, [](const NamedPlace& place) {
    std::error_code ignored;
    return !std::filesystem::exists(place.path, ignored) || vo::is_stream(place.path);
  });
  return places;
}

/// Returns all files and folders that are written, streams left out, and those first whose names
/// the user did not give.
std::vector<NamedPlace> written_places(const CLI::App& command, const FileArguments& files) {
  std::vector<NamedPlace> places = files.derived ? files.derived() : std::vector<NamedPlace>();
  add_places_of(command, files.outputs, places);
  add_places_of(command, files.written, places);
  std::erase_if(places, [](const NamedPlace& place) { return vo::is_stream(place.path); });
  return places;
}

template <typename Value>
bool is_one_of(const std::vector<Value>& values, const Value& value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

/// Says what a command reads from the folder of an input.
enum class FolderContent { sequence, scenarios };

/// Returns whether a sequence is read from a file of this name in its folder. Recordings are not
/// meant: those beside a sequence are often made of it.
bool is_read_from_sequence(const std::filesystem::path& file) {
  static constexpr std::array<std::string_view, 9> kNames{
      "rgb.txt",       "depth.txt", "groundtruth.txt", "associations.txt", "camera.toml",
      "sequence.toml", "rig.toml",  "data.csv",        "pose_left.txt"};
  static constexpr std::array<std::string_view, 4> kExtensions{".png", ".jpg", ".jpeg", ".yaml"};
  return std::find(kNames.begin(), kNames.end(), file.filename()) != kNames.end() ||
         std::find(kExtensions.begin(), kExtensions.end(), file.extension()) != kExtensions.end();
}

/// Returns whether writing the output would change what is read from the input, both resolved.
bool is_read_with(const std::filesystem::path& output, const std::filesystem::path& input,
                  FolderContent content) {
  if (output == input) {
    return true;
  }
  const std::filesystem::path within = output.lexically_relative(input);
  if (within.empty() || *within.begin() == "..") {
    return false;
  }
  return content == FolderContent::scenarios ? within.extension() == ".toml"
                                             : is_read_from_sequence(within);
}

/// Throws where two outputs are one file, in whatever way they are named.
void require_distinct_outputs(const std::vector<NamedPlace>& outputs) {
  std::map<std::filesystem::path, std::string> writers;
  for (const auto& [name, path] : outputs) {
    const auto [first, is_new] = writers.try_emplace(vo::resolved_output(path), name);
    if (!is_new && first->second != name) {
      vo::fail_as(vo::ErrorKind::usage, name, ": ", path.string(), " is written by ", first->second,
                  " already, expected another file");
    }
  }
}

/// Throws where an output would take the place of what is read, in whatever way it is named.
void require_other_than_inputs(const std::vector<NamedPlace>& outputs,
                               const std::vector<NamedPlace>& inputs, const FileArguments& files) {
  for (const NamedPlace& input : inputs) {
    const std::filesystem::path source = vo::resolved_output(input.path);
    const FolderContent content = is_one_of(files.configurations, input.name)
                                      ? FolderContent::scenarios
                                      : FolderContent::sequence;
    for (const auto& [name, path] : outputs) {
      const bool is_allowed = is_one_of(files.in_place, std::pair(input.name, name));
      if (!is_allowed && is_read_with(vo::resolved_output(path), source, content)) {
        vo::fail_as(vo::ErrorKind::usage, name, ": ", path.string(), " is read by ", input.name,
                    ", expected another file");
      }
    }
  }
}

/// Throws where the command line names one file for two purposes of which one is to write it.
void require_separate_files(const CLI::App& command, const FileArguments& files) {
  const std::vector<NamedPlace> outputs = written_places(command, files);
  require_distinct_outputs(outputs);
  require_other_than_inputs(outputs, read_places(command, files), files);
}

/// Makes `-` an error of the options that name what no stream can be.
void refuse_streams(CLI::App& command, const FileArguments& files) {
  for (const auto* names : {&files.read, &files.written, &files.others}) {
    for (const std::string& name : *names) {
      refuse_stream(*find_option(command, name));
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
  refuse_streams(command, files);
  command.parse_complete_callback([&command, taken, files] {
    require_one_output(command, *taken);
    require_separate_files(command, files);
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
