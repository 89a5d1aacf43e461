// camera.toml.
#include "tests/fuzz/fuzz_input.h"
#include "vo/dataset/camera_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "camera.toml", [](const std::filesystem::path& path) {
    const std::string text = vo::format_camera(vo::read_camera_model(path));
    fuzz::check(vo::format_camera(fuzz::read_again(text, "again", vo::read_camera_model)) == text,
                "a camera that is read and written reads alike");
  });
}
