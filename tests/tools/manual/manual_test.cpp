#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/program.h"
#include "tests/support/temp_folder.h"
#include "tools/manual/command_outline.h"
#include "tools/manual/completion.h"
#include "tools/manual/manual_page.h"
#include "vo/files/input.h"

namespace {

using testing::HasSubstr;
using testing::Not;

tools::CommandOutline example() {
  return {.name = "edvo",
          .description = "Tracks. And more.",
          .commands = {{.name = "path",
                        .description = "What a path does: it's checked",
                        .options = {{"--json", tools::OptionValue::none, "as JSON"}},
                        .commands = {{.name = "check",
                                      .description = "checks",
                                      .options = {{"--limit", tools::OptionValue::text, "m"}}}}},
                       {.name = "plan", .description = "plans"}}};
}

/// Returns what bash proposes when the last of the words is being completed.
std::string proposed(const std::string& script, const std::string& words) {
  const support::TempFolder folder;
  const std::filesystem::path path =
      folder.write("completion", script + "\nCOMP_WORDS=(" + words +
                                     ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_edvo\n"
                                     "printf '%s ' \"${COMPREPLY[@]}\"\n");
  const std::filesystem::path out = folder.write("out", "");
  const std::string command = "bash '" + path.string() + "' >'" + out.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
  return vo::read_file(out);
}

TEST(BashCompletion, ProposesCommandsTheirPartsAndOptions) {
  const std::string script = tools::completion_script(example(), tools::Shell::bash);
  EXPECT_EQ(proposed(script, "edvo p"), "path plan ");
  EXPECT_EQ(proposed(script, "edvo path ''"), "check --json ");
  EXPECT_EQ(proposed(script, "edvo path check --l"), "--limit ");
  EXPECT_EQ(proposed(script, "edvo path check --j"), " ");
}

TEST(BashCompletion, KnowsThePrograms) {
  const std::string script = support::run_program("completion bash").out;
  EXPECT_EQ(proposed(script, "edvo render --trajectory-f"), "--trajectory-format ");
  EXPECT_EQ(proposed(script, "edvo cache pr"), "prune ");
}

TEST(Completion, QuotesWhatTheHelpSays) {
  EXPECT_THAT(tools::completion_script(example(), tools::Shell::zsh), HasSubstr(R"(it'\''s)"));
  EXPECT_THAT(tools::completion_script(example(), tools::Shell::fish), HasSubstr(R"(it\'s)"));
}

TEST(ManualPage, HoldsLinesThatRoffWouldTakeForCommands) {
  tools::CommandOutline program = example();
  program.description = "One.\n.so /etc/passwd\n'br \\n";
  const std::string page = tools::manual_page(program, {"1.0", "0 ok"});
  EXPECT_THAT(page, HasSubstr("\n\\&.so /etc/passwd\n\\&'br \\en"));
  EXPECT_THAT(page, Not(HasSubstr("\n.so")));
}

TEST(ManualPage, OfACommandHasItsOptionsAndParts) {
  const tools::CommandOutline program = example();
  const std::string page = tools::manual_page(program, program.commands.front(), {"1.0", "0 ok"});
  EXPECT_THAT(page, HasSubstr(".TH EDVO-PATH 1"));
  EXPECT_THAT(page, HasSubstr(".B \\-\\-json"));
  EXPECT_THAT(page, HasSubstr(".SH CHECK"));
}

TEST(Summary, IsTheFirstSentence) {
  EXPECT_EQ(tools::summary("Reads a file\nof 1.5 m. And more."), "Reads a file of 1.5 m");
  EXPECT_EQ(tools::summary("No stop"), "No stop");
}

}  // namespace
