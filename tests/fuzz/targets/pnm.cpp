// Portable grey and pixel maps.
#include "vo/image_files/pnm.h"

#include "tests/fuzz/fuzz_input.h"
#include "tests/support/same_pixels.h"
#include "vo/image_files/image_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    const cv::Mat image = vo::read_image(path);
    const cv::Mat again = fuzz::read_again(vo::encode_pnm(image), "again", vo::read_image);
    fuzz::check(support::have_same_pixels(image, again),
                "a map that is read and written reads alike");
  });
}
