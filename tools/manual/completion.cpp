#include "tools/manual/completion.h"

#include <vector>

#include "vo/core/error.h"

namespace tools {
namespace {

/// A command with the words that lead to it: {"path", "check"}.
struct NamedCommand {
  std::string first;
  std::string second;  ///< "" for a command of the program itself
  const CommandOutline* command;
};

/// Returns all commands, those within a command before it.
std::vector<NamedCommand> commands_below(const CommandOutline& program) {
  std::vector<NamedCommand> found;
  for (const CommandOutline& command : program.commands) {
    for (const CommandOutline& part : command.commands) {
      found.push_back({command.name, part.name, &part});
    }
    found.push_back({command.name, "", &command});
  }
  return found;
}

/// Returns the words that may follow a command, with blanks between.
std::string words_after(const CommandOutline& command) {
  std::string words;
  for (const CommandOutline& part : command.commands) {
    words += (words.empty() ? "" : " ") + part.name;
  }
  for (const OptionOutline& option : command.options) {
    if (!option.is_positional) {
      words += (words.empty() ? "" : " ") + option.name;
    }
  }
  return words;
}

/// Returns the text in single quotes; `quote` is what stands within them for a single quote.
std::string quoted(const std::string& text, const std::string& quote) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? quote : std::string(1, c);
  }
  return result + "'";
}

std::string bash_script(const CommandOutline& program) {
  std::string cases;
  for (const auto& [first, second, command] : commands_below(program)) {
    cases += vo::concat("    '", first, " ", second, second.empty() ? "'*" : "'", ") words='",
                        words_after(*command), "' ;;\n");
  }
  return vo::concat("# Completion of ", program.name, " for bash.\n_", program.name, R"(() {
  local current=${COMP_WORDS[COMP_CWORD]} first= second= words
  ((COMP_CWORD > 1)) && first=${COMP_WORDS[1]}
  ((COMP_CWORD > 2)) && second=${COMP_WORDS[2]}
  case "$first $second" in
)",
                    cases, "    *) words='", words_after(program), R"(' ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o default -F _)",
                    program.name, " ", program.name, "\n");
}

/// Returns the first sentence of an option's help as zsh has it between brackets.
std::string zsh_help(const OptionOutline& option) {
  std::string help;
  for (const char c : summary(option.help)) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') {
      help += '\\';
    }
    help += c;
  }
  return help;
}

/// Returns the arguments of zsh's _arguments for a command's options, one a line.
std::string zsh_arguments(const CommandOutline& command) {
  std::string lines;
  for (const OptionOutline& option : command.options) {
    if (!option.is_positional) {
      const char* value = option.value == OptionValue::none ? "" : ":value:_files";
      const std::string spec = vo::concat("*", option.name, "[", zsh_help(option), "]", value);
      lines += vo::concat(" \\\n        ", quoted(spec, R"('\'')"));
    }
  }
  return lines;
}

std::string zsh_commands(const std::vector<CommandOutline>& commands) {
  std::string list;
  for (const CommandOutline& command : commands) {
    list += " " + quoted(command.name + ":" + summary(command.description), R"('\'')");
  }
  return list;
}

std::string zsh_script(const CommandOutline& program) {
  std::string cases;
  for (const auto& [first, second, command] : commands_below(program)) {
    cases += vo::concat("    ", quoted(vo::concat(first, " ", second), ""),
                        second.empty() ? "*" : "", ")\n");
    if (!command->commands.empty()) {
      cases += vo::concat("      commands=(", zsh_commands(command->commands),
                          ")\n      ((CURRENT == 3)) && _describe command commands\n");
    }
    cases += vo::concat("      _arguments", zsh_arguments(*command),
                        " \\\n        '*:file:_files' ;;\n");
  }
  return vo::concat("#compdef ", program.name, "\n# Completion of ", program.name, " for zsh.\n_",
                    program.name, "() {\n  local -a commands\n  commands=(",
                    zsh_commands(program.commands), R"()
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  case "$words[2] $words[3]" in
)",
                    cases, "  esac\n}\n_", program.name, " \"$@\"\n");
}

std::string fish_script(const CommandOutline& program) {
  std::string lines = vo::concat("# Completion of ", program.name, " for fish.\n");
  const std::string start = vo::concat("complete -c ", program.name, " -n ");
  for (const CommandOutline& command : program.commands) {
    lines += vo::concat(start, "__fish_use_subcommand -a ", command.name, " -d ",
                        quoted(summary(command.description), R"(\')"), "\n");
  }
  for (const auto& [first, second, command] : commands_below(program)) {
    const std::string seen = second.empty()
                                 ? vo::concat("'__fish_seen_subcommand_from ", first, "'")
                                 : vo::concat("'__fish_seen_subcommand_from ", first,
                                              "; and __fish_seen_subcommand_from ", second, "'");
    for (const CommandOutline& part : command->commands) {
      lines += vo::concat(start, seen, " -a ", part.name, " -d ",
                          quoted(summary(part.description), R"(\')"), "\n");
    }
    for (const OptionOutline& option : command->options) {
      if (!option.is_positional) {
        lines += vo::concat(start, seen, " -l ", option.name.substr(2),
                            option.value == OptionValue::none ? "" : " -r", " -d ",
                            quoted(summary(option.help), R"(\')"), "\n");
      }
    }
  }
  return lines;
}

}  // namespace

std::string completion_script(const CommandOutline& program, Shell shell) {
  switch (shell) {
    case Shell::bash:
      return bash_script(program);
    case Shell::zsh:
      return zsh_script(program);
    case Shell::fish:
      return fish_script(program);
  }
  return {};
}

}  // namespace tools
