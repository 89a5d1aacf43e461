#include "tools/cli/outline.h"

namespace tools {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

CommandOutline outline_of(const CLI::App& program) {
  CommandOutline outline{.name = program.get_name(),
                         .description = program.get_description(),
                         .footer = program.get_footer()};
  for (const CLI::Option* option : program.get_options()) {
    const bool is_flag = option->get_items_expected_max() == 0;
    const OptionValue value = is_flag ? OptionValue::none : OptionValue::text;
    const bool is_positional = option->get_lnames().empty() && option->get_snames().empty();
    if (is_positional) {
      outline.options.push_back({option->get_name(true), value, option->get_description(),
                                 is_positional, option->get_required()});
    }
    for (const std::string& name : option->get_lnames()) {
      outline.options.push_back(
          {"--" + name, value, option->get_description(), is_positional, option->get_required()});
    }
  }
  for (const CLI::App* command : commands_of(program)) {
    outline.commands.push_back(outline_of(*command));
  }
  return outline;
}

}  // namespace tools
