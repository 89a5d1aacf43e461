#include "tools/outside_tracker/tracker_command.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <unistd.h>

#include "tools/processes/shell_words.h"
#include "vo/core/error.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShellHint =
    "; to use a shell write sh -c 'vo \"$EDVO_SEQUENCE\" \"$EDVO_CAMERA\" > \"$EDVO_OUTPUT\"'";

/// A place's name in a command and in the environment.
struct PlaceName {
  std::string_view placeholder;
  std::string_view variable;
};

constexpr PlaceName kSequence{"{sequence}", "EDVO_SEQUENCE"};
constexpr PlaceName kCamera{"{camera}", "EDVO_CAMERA"};
constexpr PlaceName kOutput{"{output}", "EDVO_OUTPUT"};
constexpr std::array<PlaceName, 3> kPlaceNames{kSequence, kCamera, kOutput};

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool has_placeholder(std::string_view text) {
  return std::any_of(kPlaceNames.begin(), kPlaceNames.end(),
                     [&](const PlaceName& name) { return contains(text, name.placeholder); });
}

bool names_variable(std::string_view text) {
  return contains(text, "EDVO_");
}

const fs::path& place_of(const PlaceName& name, const TrackerPlaces& places) {
  return name.placeholder == kSequence.placeholder ? places.sequence
         : name.placeholder == kCamera.placeholder ? places.camera
                                                   : places.output;
}

/// Returns the word with each placeholder replaced once; what a value says is never replaced.
std::string substituted(std::string_view word, const TrackerPlaces& places) {
  std::string text;
  while (!word.empty()) {
    const auto name = std::find_if(kPlaceNames.begin(), kPlaceNames.end(), [&](const PlaceName& n) {
      return word.starts_with(n.placeholder);
    });
    text += name == kPlaceNames.end() ? std::string(1, word.front())
                                      : fs::absolute(place_of(*name, places)).string();
    word.remove_prefix(name == kPlaceNames.end() ? 1 : name->placeholder.size());
  }
  return text;
}

/// Returns the word as an absolute path if it names a file seen from the current folder. The first
/// word does so only with a slash in it: without, it is looked up in PATH.
std::string resolved_word(const std::string& word, bool is_first) {
  std::error_code ignored;
  const bool may_be_file = !is_first || contains(word, "/");
  return may_be_file && fs::is_regular_file(word, ignored) ? fs::absolute(word).string() : word;
}

/// Returns whether a variable of the environment would tell where the withheld folder is.
bool tells_of(const fs::path& withheld, std::string_view name, std::string_view value) {
  const std::string folder = withheld.string();
  return !folder.empty() &&
         (contains(value, folder) ||
          (name == "XDG_CACHE_HOME" && !value.empty() && folder.starts_with(value)));
}

std::vector<std::string> tracker_environment(const TrackerPlaces& places) {
  std::vector<std::pair<std::string, std::string>> own{{"TMPDIR", places.scratch.string()},
                                                       {"PWD", places.scratch.string()},
                                                       {"OLDPWD", fs::current_path().string()}};
  for (const PlaceName& name : kPlaceNames) {
    own.emplace_back(name.variable, fs::absolute(place_of(name, places)).string());
  }
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view name = text.substr(0, text.find('='));
    const bool is_replaced = std::any_of(
        own.begin(), own.end(), [&](const auto& variable) { return variable.first == name; });
    if (!is_replaced && !tells_of(places.withheld, name, text.substr(name.size() + 1))) {
      environment.emplace_back(text);
    }
  }
  for (const auto& [name, value] : own) {
    if (!tells_of(places.withheld, name, value)) {
      environment.push_back(vo::concat(name, "=", value));
    }
  }
  return environment;
}

/// Returns the view in which the sequence is read-only and the truth is not there.
PrivateView tracker_view(const TrackerPlaces& places) {
  PrivateView view{.read_only = {places.sequence}, .hidden = {}};
  const bool may_hide = !places.withheld.empty() &&
                        !contains(places.sequence.string() + "/", places.withheld.string() + "/");
  if (may_hide) {
    view.hidden.push_back(places.withheld);
  }
  return view;
}

}  // namespace

void validate_tracker_command(const std::string& command) {
  std::vector<std::string> words;
  try {
    words = split_words(command);
  } catch (const vo::Error& error) {
    vo::fail("--tracker ", command, ": ", error.what(), kShellHint);
  }
  vo::require(!words.empty(), "--tracker: expected a program and its arguments");
  for (const std::size_t script : script_indices(words)) {
    vo::require(!has_placeholder(words[script]), "--tracker ", command,
                ": has a place in the text of a script, expected its environment variable",
                kShellHint);
  }
  if (has_placeholder(command) || names_variable(command)) {
    for (const PlaceName& name : {kSequence, kOutput}) {
      vo::require(contains(command, name.placeholder) || contains(command, name.variable),
                  "--tracker ", command, ": expected ", name.placeholder, " or, in a script, $",
                  name.variable, " in it");
    }
  }
}

ChildCommand tracker_command(const std::string& command, const TrackerPlaces& places) {
  ChildCommand child{.words = split_words(command),
                     .environment = tracker_environment(places),
                     .folder = places.scratch,
                     .view = tracker_view(places)};
  for (std::size_t i = 0; i < child.words.size(); ++i) {
    child.words[i] = substituted(resolved_word(child.words[i], i == 0), places);
  }
  return child;
}

}  // namespace tools
