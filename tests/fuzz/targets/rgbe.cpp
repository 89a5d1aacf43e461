// Radiance's images of linear light.
#include "vo/image_files/rgbe.h"

#include "tests/fuzz/fuzz_input.h"
#include "tests/support/same_pixels.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    // Pixels of RGBE have more than one encoding: the first that is written is kept.
    const cv::Mat_<cv::Vec3f> image =
        fuzz::read_again(vo::encode_rgbe(vo::read_rgbe(path)), "once", vo::read_rgbe);
    const cv::Mat_<cv::Vec3f> again =
        fuzz::read_again(vo::encode_rgbe(image), "again", vo::read_rgbe);
    fuzz::check(support::have_same_pixels(image, again),
                "an RGBE image that is read and written reads alike");
  });
}
