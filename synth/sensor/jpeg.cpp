#include "synth/sensor/jpeg.h"

#include "vo/core/error.h"

namespace synth {

void JpegOptions::validate() const {
  vo::require(quality >= 0 && quality <= 100,
              "sensor.jpeg.quality: expected 1 to 100, or 0 for none, got ", quality);
}

vo::ColorImage through_jpeg(const vo::ColorImage& image, const JpegOptions& options) {
  return vo::decode_jpeg(vo::encode_jpeg(image, options.quality, options.chroma), image.size());
}

}  // namespace synth
