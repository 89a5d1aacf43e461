#include "vo/image_files/jpeg_codec.h"

#include <memory>

#include <turbojpeg.h>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr int kTightRows = 0;

struct ReleaseCodec {
  void operator()(void* codec) const { tjDestroy(codec); }
};
using Codec = std::unique_ptr<void, ReleaseCodec>;

struct ReleaseBytes {
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};

/// Throws Error if a call of libjpeg-turbo failed. A warning does not count: the image was decoded.
void require_done(int status, const Codec& codec) {
  require(status == 0 || tjGetErrorCode(codec.get()) == TJERR_WARNING,
          "JPEG: ", tjGetErrorStr2(codec.get()));
}

int subsampling(ChromaSampling chroma) {
  switch (chroma) {
    case ChromaSampling::full:
      return TJSAMP_444;
    case ChromaSampling::half:
      return TJSAMP_422;
    case ChromaSampling::quarter:
      return TJSAMP_420;
  }
  return TJSAMP_444;
}

}  // namespace

std::vector<std::uint8_t> encode_jpeg(const ColorImage& image, int quality, ChromaSampling chroma) {
  const ColorImage pixels = image.isContinuous() ? image : image.clone();
  const Codec encoder(tjInitCompress());
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): libjpeg's type
  const int status =
      tjCompress2(encoder.get(), pixels.data, pixels.cols, kTightRows, pixels.rows, TJPF_BGR,
                  &bytes, &size, subsampling(chroma), quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, ReleaseBytes> owner(bytes);
  require_done(status, encoder);
  return {bytes, bytes + size};
}

ColorImage decode_jpeg(std::span<const std::uint8_t> bytes, cv::Size size) {
  const Codec decoder(tjInitDecompress());
  int width = 0;
  int height = 0;
  int chroma = 0;
  int colour_space = 0;
  require_done(tjDecompressHeader3(decoder.get(), bytes.data(), bytes.size(), &width, &height,
                                   &chroma, &colour_space),
               decoder);
  require(cv::Size(width, height) == size, "JPEG: is ", width, " x ", height, ", expected ",
          size.width, " x ", size.height);
  ColorImage image(size);
  require_done(tjDecompress2(decoder.get(), bytes.data(), bytes.size(), image.data, width,
                             kTightRows, height, TJPF_BGR, TJFLAG_ACCURATEDCT),
               decoder);
  return image;
}

}  // namespace vo
