// TIFFs of floats.
#include "tests/fuzz/fuzz_input.h"
#include "tests/support/same_pixels.h"
#include "vo/image_files/float_tiff.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    const cv::Mat image = vo::read_float_tiff(path);
    const cv::Mat again =
        fuzz::read_again(vo::encode_float_tiff(image), "again", vo::read_float_tiff);
    fuzz::check(support::have_same_pixels(image, again),
                "a TIFF that is read and written reads alike");
  });
}
