// Optical flow in Middlebury's format.
#include "tests/fuzz/fuzz_input.h"
#include "tests/support/same_pixels.h"
#include "vo/image_files/flow_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    const cv::Mat image = vo::read_flow(path);
    const cv::Mat again = fuzz::read_again(vo::encode_flow(image), "again", vo::read_flow);
    fuzz::check(support::have_same_pixels(image, again),
                "flow that is read and written reads alike");
  });
}
