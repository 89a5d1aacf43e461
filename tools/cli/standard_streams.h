#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/cli/session.h"

namespace tools {

/// A file or folder that a command reads or writes, and what names it: an option, for most.
struct NamedPlace {
  std::string name;
  std::filesystem::path path;
};

/// The files and folders among a command's arguments, by the names of its options.
struct FileArguments {
  std::vector<std::string> inputs;          ///< files that are read whole: `-` is stdin
  std::vector<std::string> configurations;  ///< inputs of at most `vo::kMaxConfigurationBytes`
  std::vector<std::string> outputs;         ///< files that are written whole: `-` is stdout
  std::vector<std::string> read;            ///< other files and folders to read: `-` is an error
  std::vector<std::string> written;         ///< other files and folders to make: `-` is an error
  std::vector<std::string> others;          ///< folders of work and programs: `-` is an error
  std::vector<NamedPlace> defaults;         ///< what options read that are not given
  std::function<std::vector<NamedPlace>()> derived;  ///< outputs whose names follow from others';
                                                     ///< empty where there are none
  std::vector<std::pair<std::string, std::string>> in_place;  ///< an input and its output that may
                                                              ///< be one file
};

/// Lets a command take `-` for stdin and stdout, at most once each, and says so in its help. What
/// comes from stdin is read to its end before the command starts; libraries find it as the regular
/// file /dev/stdin, as often as they like, and write /dev/stdout. `./-` is a file of this name. Two
/// outputs of one name are a usage error, and so is an output that is an input or a file from which
/// the folder of an input is read, be it by links, unless `in_place` has both.
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
