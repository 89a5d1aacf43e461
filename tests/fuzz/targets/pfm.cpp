// Portable float maps.
#include "vo/image_files/pfm.h"

#include "tests/fuzz/fuzz_input.h"
#include "tests/support/same_pixels.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    const cv::Mat image = vo::read_pfm(path);
    const cv::Mat again = fuzz::read_again(vo::encode_pfm(image), "again", vo::read_pfm);
    fuzz::check(support::have_same_pixels(image, again),
                "a PFM that is read and written reads alike");
  });
}
