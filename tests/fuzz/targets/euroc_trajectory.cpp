// Ground truth in EuRoC's format, as poses and as states of the body.
#include "tests/fuzz/fuzz_input.h"
#include "vo/motion_files/imu_file.h"
#include "vo/motion_files/trajectory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::with_file(data, size, "data.csv", [](const std::filesystem::path& path) {
    vo::read_trajectory_file(path, {.format = vo::TrajectoryFormat::euroc, .times = {}});
  });
  return fuzz::with_file(data, size, "data.csv", [](const std::filesystem::path& path) {
    const auto states = vo::read_states(path);
    const auto again = fuzz::read_again(vo::format_states(states), "again", vo::read_states);
    fuzz::check(again.size() == states.size(), "as many states are read as were written");
  });
}
