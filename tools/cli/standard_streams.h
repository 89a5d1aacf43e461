#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/cli/session.h"

namespace tools {

/// The files and folders among a command's arguments, by the names of its options.
struct FileArguments {
  std::vector<std::string> inputs;          ///< files that are read whole: `-` is stdin
  std::vector<std::string> configurations;  ///< inputs of at most `vo::kMaxConfigurationBytes`
  std::vector<std::string> outputs;         ///< files that are written whole: `-` is stdout
  std::vector<std::string> others;          ///< folders and programs: `-` is an error
};

/// Lets a command take `-` for stdin and stdout, at most once each, and says so in its help. What
/// comes from stdin is read to its end before the command starts; libraries find it as the regular
/// file /dev/stdin, as often as they like, and write /dev/stdout. `./-` is a file of this name. Two
/// outputs of one name are a usage error.
void take_streams(CLI::App& command, const FileArguments& files);

/// Opens /dev/null in the place of each of stdin, stdout and stderr that is closed, so that no file
/// that is opened later becomes one of them. Stdin is opened for writing and the others for
/// reading: what reads or writes them fails as it does where they are closed.
void fill_closed_streams();

/// A Speech is the stream on which a command speaks to people, with the colours of that stream.
struct Speech {
  std::ostream& stream;
  Colours colours;
};

/// Returns stdout, or stderr where one of the outputs is stdout.
Speech speech_beside(const Session& session, const std::vector<std::filesystem::path>& outputs);

}  // namespace tools
