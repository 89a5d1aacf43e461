#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "tools/plot/table.h"
#include "tools/sequence_cache/sequence_cache.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr const char* kCacheHelp =
    "The sequences that `edvo test` has rendered and keeps. Any number of programs may use one\n"
    "cache at once; nothing in use is removed, and what is removed is rendered again when needed.";

constexpr std::string_view kSound = "ok";  // state of a sequence without a problem

struct CacheArguments {
  bool json = false;
  bool quiet = false;
  std::string folder;
  std::string max_size;

  std::filesystem::path cache() const { return cache_folder(folder); }
};

/// Parses a number of bytes such as "500M"; k, M, G multiply by 1e3, 1e6, 1e9. Throws vo::Error.
std::uintmax_t parse_bytes(const std::string& text) {
  constexpr std::string_view kUnits = "kMG";
  const std::size_t unit = text.empty() ? std::string_view::npos : kUnits.find(text.back());
  const bool has_unit = unit != std::string_view::npos;
  try {
    const double number = vo::parse_real(text.substr(0, text.size() - (has_unit ? 1 : 0)));
    vo::require(number >= 0, "negative");
    return static_cast<std::uintmax_t>(
        number * (has_unit ? std::pow(1000.0, static_cast<double>(unit + 1)) : 1));
  } catch (const vo::Error&) {
    vo::fail_as(vo::ErrorKind::usage, "--max-size ", text, ": expected bytes, such as 500M or 2G");
  }
}

nlohmann::ordered_json entry_json(const CacheEntry& entry) {
  return {{"key", entry.key},
          {"scene", entry.scene},
          {"frames", entry.frames},
          {"bytes", entry.bytes},
          {"problem", entry.problem}};
}

/// Prints what an action did as JSON: the sequences that it lists, verified or removed.
void print_json(const CacheArguments& arguments, const char* action,
                const std::vector<CacheEntry>& entries) {
  nlohmann::ordered_json sequences = nlohmann::ordered_json::array();
  for (const CacheEntry& entry : entries) {
    sequences.push_back(entry_json(entry));
  }
  std::cout << json_text(json_document(
      {"cache"},
      {{"action", action}, {"folder", arguments.cache().string()}, {"sequences", sequences}}));
}

std::optional<Tone> tone_of_state(std::string_view state) {
  return state == kSound ? std::optional<Tone>() : Tone::bad;
}

void print_table(const std::vector<CacheEntry>& entries, const std::string& what,
                 const Colours& colours) {
  Table table{
      .columns = {{"sequence"}, {"scene"}, {"frames"}, {"MB", 1}, {"state", 0, tone_of_state}}};
  double bytes = 0;
  for (const CacheEntry& entry : entries) {
    bytes += static_cast<double>(entry.bytes);
    table.add_row({entry.key, entry.scene, static_cast<double>(entry.frames),
                   static_cast<double>(entry.bytes) / kBytesPerMegabyte,
                   entry.problem.empty() ? std::string(kSound) : entry.problem});
  }
  std::cout << (entries.empty() ? "" : as_text(table, colours)) << entries.size() << " " << what
            << ", " << format_decimals(bytes / kBytesPerMegabyte, 1) << " MB\n";
}

/// Prints what an action did, for people or as JSON; `what` ends the sentence on how many sequences
/// there are.
void print(const CacheArguments& arguments, const char* action,
           const std::vector<CacheEntry>& entries, const std::string& what,
           const Session& session) {
  if (arguments.json) {
    print_json(arguments, action, entries);
  } else {
    print_table(entries, what, session.out);
  }
}

void list(const CacheArguments& arguments, const Session& session) {
  print(arguments, "list", list_cache(arguments.cache()),
        "sequences in " + arguments.cache().string(), session);
}

void verify(const CacheArguments& arguments, const Session& session) {
  ProgressBar bar("verifying", CommonOptions{.quiet = arguments.quiet}.verbosity());
  bar.announce();
  const std::vector<CacheEntry> entries = verify_cache(arguments.cache(), bar.callback());
  bar.erase();
  const auto broken = std::count_if(entries.begin(), entries.end(),
                                    [](const CacheEntry& entry) { return !entry.problem.empty(); });
  print(arguments, "verify", entries,
        vo::concat("sequences, of which ", broken, " were broken and are removed"), session);
}

void prune(const CacheArguments& arguments, const Session& session) {
  print(arguments, "prune", prune_cache(arguments.cache(), parse_bytes(arguments.max_size)),
        "sequences removed", session);
}

void add_action(CLI::App& command, const std::shared_ptr<CacheArguments>& arguments,
                const std::pair<const char*, const char*>& name_and_help,
                void (*action)(const CacheArguments&, const Session&), const Session& session) {
  CLI::App& sub = *command.add_subcommand(name_and_help.first, name_and_help.second);
  sub.add_option("--cache", arguments->folder, "folder of the cache [$XDG_CACHE_HOME/edvo]");
  add_json_flag(sub, arguments->json);
  if (action == verify) {
    add_quiet_flag(sub, arguments->quiet);
  }
  if (action == prune) {
    sub.add_option("--max-size", arguments->max_size, "what may stay: bytes, 500M, 2G")->required();
  }
  take_streams(sub, {.others = {"--cache"}});
  sub.callback([arguments, action, &session] { action(*arguments, session); });
}

}  // namespace

void add_cache_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("cache", kCacheHelp);
  const auto arguments = std::make_shared<CacheArguments>();
  command.require_subcommand(1);
  add_action(command, arguments, {"list", "what is in it, the longest unused first"}, list,
             session);
  add_action(command, arguments,
             {"verify", "reads every file; removes sequences that are not as they were written"},
             verify, session);
  add_action(command, arguments, {"prune", "removes the longest unused until the rest is small"},
             prune, session);
}

}  // namespace tools
