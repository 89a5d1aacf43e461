#include <iostream>
#include <memory>
#include <string>

#include "tools/cli/options.h"
#include "tools/cli/outline.h"
#include "tools/commands/commands.h"
#include "tools/manual/completion.h"
#include "tools/manual/manual_page.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/version.h"

namespace tools {
namespace {

enum class ManualFormat { man, markdown };

constexpr auto enum_names(ManualFormat) {
  return std::array{std::pair{ManualFormat::man, "man"},
                    std::pair{ManualFormat::markdown, "markdown"}};
}

struct ManualArguments {
  std::string command;
  std::string format = "man";
};

const CommandOutline& command_of(const CommandOutline& program, const std::string& name) {
  for (const CommandOutline& command : program.commands) {
    if (command.name == name) {
      return command;
    }
  }
  vo::fail_as(vo::ErrorKind::usage, "there is no command ", name, " (edvo --help lists all)");
}

void print_manual(const CLI::App& program, const ManualArguments& arguments) {
  const CommandOutline outline = outline_of(program);
  const ManualEdition edition{vo::version(), outline.footer};
  if (vo::parse_enum<ManualFormat>(arguments.format) == ManualFormat::markdown) {
    std::cout << markdown_reference(outline);
  } else if (arguments.command.empty()) {
    std::cout << manual_page(outline, edition);
  } else {
    std::cout << manual_page(outline, command_of(outline, arguments.command), edition);
  }
}

}  // namespace

void add_completion_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand(
      "completion",
      "Prints the script by which a shell completes commands and options. For bash:\n"
      "source <(edvo completion bash); packages install all three.");
  const auto shell = std::make_shared<std::string>();
  command.add_option("SHELL", *shell, "bash | zsh | fish")->required()->check(is_name_of<Shell>());
  command.callback([&program, shell] {
    std::cout << completion_script(outline_of(program), vo::parse_enum<Shell>(*shell));
  });
}

void add_manual_command(CLI::App& program, Session& /*session*/) {
  CLI::App& command = *program.add_subcommand(
      "manual",
      "Prints the manual page of the program or of a command, made of its own --help. To read it:\n"
      "edvo manual render | man -l -");
  const auto arguments = std::make_shared<ManualArguments>();
  command.add_option("COMMAND", arguments->command, "command, as `render` [the program]");
  command.add_option("--format", arguments->format, "man | markdown, all commands [man]")
      ->check(is_name_of<ManualFormat>());
  command.callback([&program, arguments] { print_manual(program, *arguments); });
}

}  // namespace tools
