// Readings of an IMU, and its noise.
#include "tests/fuzz/fuzz_input.h"
#include "vo/motion_files/imu_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::with_file(data, size, "imu.toml", [](const std::filesystem::path& path) {
    const std::string text = vo::format_imu_noise(vo::read_imu_noise(path));
    fuzz::check(vo::format_imu_noise(fuzz::read_again(text, "again", vo::read_imu_noise)) == text,
                "noise that is read and written reads alike");
  });
  return fuzz::with_file(data, size, "imu.csv", [](const std::filesystem::path& path) {
    const std::string text = vo::format_imu(vo::read_imu(path));
    fuzz::check(vo::format_imu(fuzz::read_again(text, "again", vo::read_imu)) == text,
                "readings that are read and written read alike");
  });
}
