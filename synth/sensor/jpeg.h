#pragma once

#include "vo/core/image.h"
#include "vo/image_files/jpeg_codec.h"

namespace synth {

struct JpegOptions {
  int quality = 0;  ///< 1 to 100; 0 = not compressed
  vo::ChromaSampling chroma = vo::ChromaSampling::quarter;

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, JpegOptions& options) {
  visit("quality", options.quality, "of JPEG compression, 1 to 100; 0 = none");
  visit("chroma", options.chroma, "samples of colour per pixel");
}

/// Returns the image after JPEG compression and decompression.
vo::ColorImage through_jpeg(const vo::ColorImage& image, const JpegOptions& options);

}  // namespace synth
