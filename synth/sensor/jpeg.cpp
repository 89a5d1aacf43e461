#include "synth/sensor/jpeg.h"

#include <memory>

#include <turbojpeg.h>

#include "vo/core/error.h"

namespace synth {
namespace {

struct ReleaseCodec {
  void operator()(void* codec) const { tjDestroy(codec); }
};
using Codec = std::unique_ptr<void, ReleaseCodec>;

struct ReleaseBytes {
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};

void require_done(int status, const Codec& codec) {
  vo::require(status == 0, "JPEG: ", tjGetErrorStr2(codec.get()));
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

void JpegOptions::validate() const {
  vo::require(quality >= 0 && quality <= 100,
              "sensor.jpeg.quality: expected 1 to 100, or 0 for none, got ", quality);
}

vo::ColorImage through_jpeg(const vo::ColorImage& image, const JpegOptions& options) {
  constexpr int kTightRows = 0;
  const vo::ColorImage pixels = image.isContinuous() ? image : image.clone();
  const Codec encoder(tjInitCompress());
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): libjpeg's
  const int status =
      tjCompress2(encoder.get(), pixels.data, pixels.cols, kTightRows, pixels.rows, TJPF_BGR,
                  &bytes, &size, subsampling(options.chroma), options.quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, ReleaseBytes> owner(bytes);
  require_done(status, encoder);

  const Codec decoder(tjInitDecompress());
  vo::ColorImage result(image.size());
  require_done(tjDecompress2(decoder.get(), bytes, size, result.data, result.cols, kTightRows,
                             result.rows, TJPF_BGR, TJFLAG_ACCURATEDCT),
               decoder);
  return result;
}

}  // namespace synth
