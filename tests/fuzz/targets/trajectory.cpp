// Trajectories in TUM's format.
#include <cmath>
#include <limits>

#include "tests/fuzz/fuzz_input.h"
#include "vo/motion_files/trajectory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "t.txt", [](const std::filesystem::path& path) {
    const vo::Trajectory read = vo::read_trajectory(path);
    const vo::Trajectory again =
        fuzz::read_again(vo::format_trajectory(read), "again", vo::read_trajectory);
    fuzz::check(again.size() == read.size(), "as many poses are read as were written");
    for (std::size_t i = 0; i < read.size(); ++i) {
      const vo::SE3 difference = read[i].T_world_camera.inverse() * again[i].T_world_camera;
      const double distance = difference.translation().norm();
      const double extent = read[i].T_world_camera.translation().norm();
      const double spacing = 1e-9 + std::abs(read[i].timestamp) *
                                        std::numeric_limits<double>::epsilon();  // of doubles, s
      fuzz::check(std::abs(read[i].timestamp - again[i].timestamp) <= 0.5e-6 + spacing,
                  "stamps are written to a microsecond or finer");
      fuzz::check(distance <= 1e-8 + 1e-7 * extent, "positions are written to a nanometre");
    }
  });
}
