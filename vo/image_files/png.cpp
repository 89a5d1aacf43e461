#include "vo/image_files/png.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <png.h>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/new_image.h"

namespace vo {
namespace {

constexpr int kSignatureBytes = 8;
/// Stands for every chunk that the pixels do not need. libpng asks for as much memory as the header
/// of an eXIf chunk states, whatever the file holds; skipped, its stated length costs nothing.
constexpr int kAllAncillaryChunks = -1;
constexpr int kCompressionLevel = 3;  // a higher level halves the speed for 5 % fewer bytes

/// Error message that libpng's callbacks leave. libpng reports an error by calling `on_error`,
/// which must not return: it leaves by longjmp to the setjmp of the function that called libpng.
/// Those functions hold no object with a destructor.
struct PngError {
  std::array<char, 128> message{};
  bool is_out_of_memory = false;
};

struct ByteSource {
  std::string_view bytes;
  std::size_t position = 0;
};

void on_error(png_structp png, png_const_charp message) {
  auto* error = static_cast<PngError*>(png_get_error_ptr(png));
  std::strncpy(error->message.data(), message, error->message.size() - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

void read_bytes(png_structp png, png_bytep target, std::size_t count) {
  auto* source = static_cast<ByteSource*>(png_get_io_ptr(png));
  if (source->bytes.size() - source->position < count) {
    png_error(png, "it is truncated");
  }
  std::memcpy(target, source->bytes.data() + source->position, count);
  source->position += count;
}

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto* target = static_cast<std::string*>(png_get_io_ptr(png));
  target->append(reinterpret_cast<const char*>(bytes), count);
}

void flush_nothing(png_structp /*png*/) {}

png_voidp allocate(png_structp png, png_alloc_size_t size) {
  // NOLINTNEXTLINE(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory): libpng's own
  void* memory = std::malloc(size);
  if (memory == nullptr) {
    static_cast<PngError*>(png_get_mem_ptr(png))->is_out_of_memory = true;
  }
  return memory;
}

void release(png_structp /*png*/, png_voidp memory) {
  // NOLINTNEXTLINE(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory): as allocated
  std::free(memory);
}

/// Throws Error unless libpng has succeeded.
void require_decoded(bool succeeded, const PngError& error, const std::filesystem::path& path) {
  if (!succeeded && error.is_out_of_memory) {
    fail_as(ErrorKind::temporary, path.string(), ": there is not enough memory to decode it");
  }
  require(succeeded, path.string(), ": cannot be decoded: ", error.message.data());
}

/// Owns libpng's state for reading.
class PngReadState {
 public:
  explicit PngReadState(PngError& error)
      : png_(png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning, &error,
                                      allocate, release)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    if (info_ == nullptr) {
      error.is_out_of_memory = true;
    }
  }
  ~PngReadState() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReadState(const PngReadState&) = delete;
  PngReadState& operator=(const PngReadState&) = delete;
  PngReadState(PngReadState&&) = delete;
  PngReadState& operator=(PngReadState&&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

 private:
  png_structp png_;
  png_infop info_;
};

/// Owns libpng's state for writing.
class PngWriteState {
 public:
  explicit PngWriteState(PngError& error)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning)),
        info_(png_create_info_struct(png_)) {}
  ~PngWriteState() { png_destroy_write_struct(&png_, &info_); }
  PngWriteState(const PngWriteState&) = delete;
  PngWriteState& operator=(const PngWriteState&) = delete;
  PngWriteState(PngWriteState&&) = delete;
  PngWriteState& operator=(PngWriteState&&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

 private:
  png_structp png_;
  png_infop info_;
};

/// Asks libpng for CV_8UC1, CV_8UC3 or CV_16UC1 pixels.
void ask_for_measurements(png_structp png, png_infop info) {
  const bool is_gray = (png_get_color_type(png, info) & PNG_COLOR_MASK_COLOR) == 0;
  if (png_get_bit_depth(png, info) == 16 && is_gray) {
    png_set_swap(png);
  } else {
    png_set_scale_16(png);
  }
  png_set_expand(png);
  png_set_strip_alpha(png);
  png_set_bgr(png);
}

/// Asks libpng for CV_8UC4 pixels, red first.
void ask_for_rgba(png_structp png, png_infop /*info*/) {
  constexpr png_uint_32 kOpaque = 255;
  png_set_scale_16(png);
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, kOpaque, PNG_FILLER_AFTER);
}

using PixelRequest = void (*)(png_structp, png_infop);

/// Reads the header and asks libpng for pixels; false on error.
bool read_header(png_structp png, png_infop info, ByteSource* source, PixelRequest ask) {
  if (setjmp(png_jmpbuf(png)) != 0) {  // NOLINT(cert-err52-cpp)
    return false;
  }
  png_set_read_fn(png, source, read_bytes);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, kAllAncillaryChunks);
  png_read_info(png, info);
  ask(png, info);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) {  // NOLINT(cert-err52-cpp)
    return false;
  }
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

bool write_rows(png_structp png, png_infop info, const cv::Mat& image, png_bytepp rows,
                std::string* target) {
  if (setjmp(png_jmpbuf(png)) != 0) {  // NOLINT(cert-err52-cpp)
    return false;
  }
  png_set_write_fn(png, target, append_bytes, flush_nothing);
  png_set_compression_level(png, kCompressionLevel);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.cols),
               static_cast<png_uint_32>(image.rows), image.depth() == CV_16U ? 16 : 8,
               image.channels() == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (image.depth() == CV_16U) {
    png_set_swap(png);
  }
  png_set_bgr(png);
  png_write_image(png, rows);
  png_write_end(png, nullptr);
  return true;
}

std::vector<png_bytep> row_pointers(const cv::Mat& image) {
  std::vector<png_bytep> rows;
  for (int v = 0; v < image.rows; ++v) {
    rows.push_back(const_cast<png_bytep>(image.ptr(v)));
  }
  return rows;
}

int image_type(png_structp png, png_infop info) {
  if (const png_byte channels = png_get_channels(png, info); channels >= 3) {
    return CV_8UC(channels);
  }
  return png_get_bit_depth(png, info) == 16 ? CV_16UC1 : CV_8UC1;
}

/// Throws Error if the file is shorter than its pixels can be compressed to: deflate makes at most
/// 1032 bytes of one, a palette's bit four bytes.
void require_long_enough(const PngReadState& state, std::size_t bytes,
                         const std::filesystem::path& path) {
  constexpr std::size_t kMostExpansion = 1032 * 8 * 4;
  const png_uint_32 width = png_get_image_width(state.png(), state.info());
  const png_uint_32 height = png_get_image_height(state.png(), state.info());
  const std::size_t pixel_bytes = png_get_rowbytes(state.png(), state.info()) * height;
  require(bytes >= pixel_bytes / kMostExpansion, path.string(), ": cannot be decoded: it has ",
          bytes, " bytes, too few for ", width, "x", height, " px");
}

/// Returns how many bytes the file has of compressed pixels.
std::size_t compressed_bytes(std::string_view bytes) {
  constexpr std::size_t kHead = 8;  // bytes: length, name
  constexpr std::size_t kChecksum = 4;
  std::size_t total = 0;
  for (std::size_t at = kSignatureBytes; at + kHead <= bytes.size();) {
    const std::string_view chunk = bytes.substr(at);
    const std::size_t length = png_get_uint_32(reinterpret_cast<png_const_bytep>(chunk.data()));
    if (chunk.substr(4, 4) == "IDAT") {
      total += std::min(length, chunk.size() - kHead);
    }
    at += kHead + length + kChecksum;
  }
  return total;
}

/// Throws Error if the file has far more compressed bytes than its pixels can need, which libpng
/// would decompress all the same: deflate makes at most a few bytes more of what has no pattern.
void require_short_enough(const PngReadState& state, std::string_view bytes,
                          const std::filesystem::path& path) {
  constexpr std::size_t kLeastLimit = 1U << 16U;
  const png_uint_32 width = png_get_image_width(state.png(), state.info());
  const png_uint_32 height = png_get_image_height(state.png(), state.info());
  constexpr std::size_t kMostPixelBytes = 8;
  const std::size_t limit = std::size_t{2} * kMostPixelBytes * width * height + kLeastLimit;
  const std::size_t compressed = compressed_bytes(bytes);
  require(compressed <= limit, path.string(), ": cannot be decoded: it has ", compressed,
          " bytes of pixels, too many for ", width, "x", height, " px");
}

cv::Mat decode(std::string_view bytes, const std::filesystem::path& path, PixelRequest ask) {
  require(is_png(bytes), path.string(), ": is not a PNG image");
  PngError error;
  const PngReadState state(error);
  ByteSource source{bytes};
  require_decoded(!error.is_out_of_memory && read_header(state.png(), state.info(), &source, ask),
                  error, path);
  require_long_enough(state, bytes.size(), path);
  require_short_enough(state, bytes, path);
  cv::Mat image = new_image({static_cast<int>(png_get_image_width(state.png(), state.info())),
                             static_cast<int>(png_get_image_height(state.png(), state.info()))},
                            image_type(state.png(), state.info()), path);
  std::vector<png_bytep> rows = row_pointers(image);
  require_decoded(read_rows(state.png(), rows.data()), error, path);
  return image;
}

}  // namespace

bool is_png(std::string_view bytes) {
  return bytes.size() >= kSignatureBytes &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignatureBytes) == 0;
}

cv::Mat read_png(const std::filesystem::path& path) {
  return decode_png(read_file(path), path);
}

cv::Mat decode_png(std::string_view bytes, const std::filesystem::path& path) {
  return decode(bytes, path, ask_for_measurements);
}

cv::Mat_<cv::Vec4b> decode_png_rgba(std::string_view bytes, const std::filesystem::path& path) {
  return decode(bytes, path, ask_for_rgba);
}

std::string encode_png(const cv::Mat& image) {
  PngError error;
  const PngWriteState state(error);
  std::vector<png_bytep> rows = row_pointers(image);
  std::string bytes;
  require(write_rows(state.png(), state.info(), image, rows.data(), &bytes),
          "an image cannot be encoded as PNG: ", error.message.data());
  return bytes;
}

}  // namespace vo
