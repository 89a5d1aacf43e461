#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/program.h"
#include "tests/support/temp_folder.h"
#include "vo/files/input.h"

namespace support {

/// A test that runs the program in a folder of its own.
class ProgramTest : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

  /// The path of a file as a word of a shell's command.
  std::string path(const std::string& name) const { return "'" + file(name).string() + "'"; }

  bool exists(const std::string& name) const { return std::filesystem::exists(file(name)); }

  bool has_leftovers() const { return support::has_leftovers(folder_.path()); }

  std::string read(const std::string& name) const { return vo::read_file(file(name)); }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    return folder_.write(name, bytes);
  }

  /// Writes the small scenario with this limit of its ATE, m, beside the project's assets.
  std::filesystem::path write_scenario(const std::string& name, const std::string& limit) const {
    if (!exists("assets")) {
      std::filesystem::create_directory_symlink(EDVO_SOURCE_DIR "/assets", file("assets"));
    }
    return write("scenarios/" + name + ".toml", kScenario + limit + "\n");
  }

 private:
  static constexpr const char* kScenario = R"(why = "it is broken"
[scene]
gltf = "room/room.gltf"
[camera]
width = 160
height = 120
[path]
kind = "orbit"
rate = 30.0
duration = 0.2
orbit.centre = [-0.95, 0.5, 0.3]
orbit.radius = 1.2
orbit.height = 0.8
[render]
samples = 1
[expect]
tracked_fraction = { min = 1.0 }
ate_rmse_m.max = )";

  TempFolder folder_;
};

}  // namespace support
