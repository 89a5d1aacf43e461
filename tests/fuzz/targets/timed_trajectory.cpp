// Trajectories without stamps, t.txt, and the list that has them, times.txt.
#include "tests/fuzz/fuzz_input.h"
#include "vo/motion_files/trajectory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_folder(data, size, [](const std::filesystem::path& folder) {
    const vo::TrajectoryFile file =
        vo::read_trajectory_file(folder / "t.txt", {.format = {}, .times = folder / "times.txt"});
    fuzz::check(!file.trajectory.empty(), "a trajectory that is read has poses");
    for (std::size_t i = 1; i < file.trajectory.size(); ++i) {
      fuzz::check(file.trajectory[i].timestamp > file.trajectory[i - 1].timestamp,
                  "stamps increase");
    }
  });
}
