// NumPy arrays of floats.
#include "vo/image_files/npy.h"

#include "tests/fuzz/fuzz_input.h"
#include "tests/support/same_pixels.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    const cv::Mat image = vo::read_npy(path);
    const cv::Mat again = fuzz::read_again(vo::encode_npy(image), "again", vo::read_npy);
    fuzz::check(support::have_same_pixels(image, again),
                "an array that is read and written reads alike");
  });
}
