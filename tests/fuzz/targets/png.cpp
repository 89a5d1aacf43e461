// PNG: 8-bit grey and colour, 16-bit grey.
#include "vo/image_files/png.h"

#include "tests/fuzz/fuzz_input.h"
#include "tests/support/same_pixels.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    const cv::Mat image = vo::read_png(path);
    const cv::Mat again = fuzz::read_again(vo::encode_png(image), "again", vo::read_png);
    fuzz::check(support::have_same_pixels(image, again),
                "a PNG that is read and written reads alike");
  });
}
