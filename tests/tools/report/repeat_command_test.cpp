#include "tools/report/repeat_command.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

/// Returns the words that a shell makes of a command, one a line.
std::vector<std::string> words_in_a_shell(const std::string& command) {
  FILE* pipe = ::popen(("printf '%s\\n' " + command).c_str(), "r");
  std::string text;
  std::array<char, 256> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    text += buffer.data();
  }
  ::pclose(pipe);
  std::istringstream lines(text);
  std::vector<std::string> words;
  for (std::string line; std::getline(lines, line);) {
    words.push_back(line);
  }
  return words;
}

TEST(RepeatCommand, IsReadByAShellAsItWasMeant) {
  tools::Scenario scenario;
  scenario.file = "it's $(mine)/a room.toml";
  scenario.name = "a room";
  const std::string tracker = "my_vo --in {sequence} --out '{output}' --gain 2";
  EXPECT_EQ(words_in_a_shell(tools::repeat_run(scenario).command),
            (std::vector<std::string>{"edvo", "run", "it's $(mine)/a room.toml", "--out",
                                      "a room_again"}));
  EXPECT_EQ(
      words_in_a_shell(tools::repeat_test(scenario, tracker).command),
      (std::vector<std::string>{"edvo", "test", "it's $(mine)/a room.toml", "--bounds", "none",
                                "--tracker", tracker, "--report", "a room_again.html"}));
}

TEST(RepeatCommand, NamesTheFolderThatItWorksIn) {
  tools::Scenario scenario;
  scenario.file = "-room.toml";
  scenario.name = "-room";
  const tools::RepeatCommand repeat = tools::repeat_run(scenario);
  EXPECT_EQ(repeat.folder, std::filesystem::current_path());
  EXPECT_EQ(repeat.command, "edvo run ./-room.toml --out ./-room_again");
}

}  // namespace
