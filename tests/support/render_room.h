#pragma once

#include <filesystem>
#include <string>

#include "tests/support/program.h"

namespace support {

/// Renders a circle in the furnished room, five frames a second, one sample per pixel; `before` as
/// for `run_program`.
inline ProgramResult render_room(const std::filesystem::path& out, const std::string& options,
                                 const std::string& before = "") {
  return run_program(
      std::string("render '") + EDVO_SOURCE_DIR +
          "/assets/room/room.gltf' --path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 "
          "--orbit.height 0.8 --rate 5 --samples 1 --quiet " +
          options + " --out '" + out.string() + "'",
      before);
}

}  // namespace support
