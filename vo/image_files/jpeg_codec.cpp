#include "vo/image_files/jpeg_codec.h"

#include <memory>

#include <turbojpeg.h>

#include "vo/core/error.h"
#include "vo/image_files/new_image.h"

namespace vo {
namespace {

constexpr int kTightRows = 0;
/// A progressive JPEG is decoded up to its 500th scan, each of which takes as long as the image.
constexpr int kDecoding = TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS;

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

/// What a JPEG file's header says.
struct JpegHeader {
  cv::Size size;
  int chroma = 0;
  int color_space = 0;
};

JpegHeader read_jpeg_header(const Codec& decoder, const std::uint8_t* bytes, std::size_t count) {
  JpegHeader header;
  require_done(tjDecompressHeader3(decoder.get(), bytes, count, &header.size.width,
                                   &header.size.height, &header.chroma, &header.color_space),
               decoder);
  require(header.color_space != TJCS_CMYK && header.color_space != TJCS_YCCK,
          "JPEG: has the inks of a print, CMYK, expected grey or colour");
  return header;
}

/// Throws Error if a file is shorter than its blocks of 8 x 8 px can be compressed to: even those
/// of one colour take more than a bit in a hundred.
void require_jpeg_long_enough(cv::Size size, std::size_t bytes) {
  constexpr std::size_t kMostPixelsPerByte = 100 * 8 * 64;
  const std::size_t pixels =
      static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  require(bytes >= pixels / kMostPixelsPerByte, "it has ", bytes, " bytes, too few for ",
          size.width, "x", size.height, " px");
}

/// Throws Error if libjpeg-turbo made up what was missing at the end.
void require_whole(const Codec& codec) {
  const std::string_view warning = tjGetErrorStr2(codec.get());
  require(tjGetErrorCode(codec.get()) != TJERR_WARNING ||
              warning.find("Premature end") == std::string_view::npos,
          "it is truncated");
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
  const JpegHeader header = read_jpeg_header(decoder, bytes.data(), bytes.size());
  require(header.size == size, "JPEG: is ", header.size.width, " x ", header.size.height,
          ", expected ", size.width, " x ", size.height);
  ColorImage image(size);
  require_done(tjDecompress2(decoder.get(), bytes.data(), bytes.size(), image.data, size.width,
                             kTightRows, size.height, TJPF_BGR, kDecoding),
               decoder);
  return image;
}

bool is_jpeg(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff");
}

cv::Mat decode_jpeg(std::string_view bytes, const std::filesystem::path& path) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const Codec decoder(tjInitDecompress());
  try {
    const JpegHeader header = read_jpeg_header(decoder, data, bytes.size());
    require_jpeg_long_enough(header.size, bytes.size());
    const bool is_gray = header.color_space == TJCS_GRAY;
    cv::Mat image = new_image(header.size, is_gray ? CV_8UC1 : CV_8UC3, path);
    require_done(tjDecompress2(decoder.get(), data, bytes.size(), image.data, image.cols,
                               kTightRows, image.rows, is_gray ? TJPF_GRAY : TJPF_BGR, kDecoding),
                 decoder);
    require_whole(decoder);
    return image;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) {
      throw;
    }
    fail(path.string(), ": cannot be decoded: ", error.what());
  }
}

}  // namespace vo
