#include "tools/manual/manual_page.h"

#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns a text as roff prints it: no character of it is a command, and hyphens can be copied.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool begins_line = result.empty() || result.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) {
      result += "\\&";
    }
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return result;
}

std::string upper(std::string text) {
  for (char& c : text) {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return text;
}

std::string title(const std::string& name, const ManualEdition& edition) {
  return vo::concat(".TH ", upper(name), " 1 \"\" \"edvo ", edition.version, "\" \"edvo\"\n");
}

/// Returns a text whose lines stay as they are.
std::string verbatim(const std::string& text) {
  return vo::concat(".nf\n", roff(text), "\n.fi\n");
}

std::string options_section(const CommandOutline& command) {
  std::string text;
  for (const OptionOutline& option : command.options) {
    const char* value = option.value == OptionValue::none || option.is_positional ? "" : " VALUE";
    text += vo::concat(".TP\n.B ", roff(option.name), value, "\n", roff(option.help),
                       option.is_required ? " (required)" : "", "\n");
  }
  return text.empty() ? "" : ".SH OPTIONS\n" + text;
}

std::string commands_section(const CommandOutline& program) {
  std::string text;
  for (const CommandOutline& command : program.commands) {
    text +=
        vo::concat(".TP\n.B ", roff(command.name), "\n", roff(summary(command.description)), "\n");
  }
  return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

std::string synopsis(const CommandOutline& command, const std::string& words) {
  std::string text = vo::concat(".SH SYNOPSIS\n.B ", roff(words), "\n");
  for (const OptionOutline& option : command.options) {
    if (option.is_positional) {
      text += roff(option.name) + "\n";
    }
  }
  return text + (command.commands.empty() ? "" : "COMMAND\n") + "[OPTION...]\n";
}

void add_markdown(const CommandOutline& command, const std::string& words, std::string& text) {
  text += vo::concat("\n## ", words, "\n\n```text\n", command.description, "\n```\n");
  if (!command.options.empty()) {
    text += "\n| option | meaning |\n|---|---|\n";
  }
  for (const OptionOutline& option : command.options) {
    std::string help;
    for (const char c : option.help) {
      help += c == '|' ? "\\|" : c == '\n' ? " " : c == '<' ? "&lt;" : std::string(1, c);
    }
    text += vo::concat("| `", option.name, "` | ", help, option.is_required ? " (required)" : "",
                       " |\n");
  }
  if (!command.footer.empty()) {
    text += vo::concat("\n```text\n", command.footer, "\n```\n");
  }
  for (const CommandOutline& part : command.commands) {
    add_markdown(part, words + " " + part.name, text);
  }
}

}  // namespace

std::string manual_page(const CommandOutline& program, const ManualEdition& edition) {
  return vo::concat(title(program.name, edition), ".SH NAME\n", program.name, " \\- ",
                    roff(summary(program.description)), "\n", synopsis(program, program.name),
                    ".SH DESCRIPTION\n", verbatim(program.description), commands_section(program),
                    options_section(program), ".SH EXIT STATUS\n", verbatim(edition.exit_codes));
}

std::string manual_page(const CommandOutline& program, const CommandOutline& command,
                        const ManualEdition& edition) {
  const std::string name = program.name + "-" + command.name;
  std::string text = vo::concat(
      title(name, edition), ".SH NAME\n", roff(name), " \\- ", roff(summary(command.description)),
      "\n", synopsis(command, program.name + " " + command.name), ".SH DESCRIPTION\n",
      roff(command.description), "\n", options_section(command));
  for (const CommandOutline& part : command.commands) {
    text += vo::concat(".SH ", upper(part.name), "\n", roff(part.description), "\n");
    for (const OptionOutline& option : part.options) {
      text += vo::concat(".TP\n.B ", roff(option.name), "\n", roff(option.help), "\n");
    }
  }
  if (!command.footer.empty()) {
    text += ".SH NOTES\n" + verbatim(command.footer);
  }
  return vo::concat(text, ".SH EXIT STATUS\n", verbatim(edition.exit_codes), ".SH SEE ALSO\n.BR ",
                    program.name, " (1)\n");
}

std::string markdown_reference(const CommandOutline& program) {
  std::string text =
      vo::concat("# Commands of ", program.name, "\n\n```text\n", program.description, "\n```\n");
  for (const CommandOutline& command : program.commands) {
    add_markdown(command, program.name + " " + command.name, text);
  }
  return text;
}

}  // namespace tools
