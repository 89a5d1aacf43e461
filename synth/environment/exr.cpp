#include "synth/environment/exr.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <openexr.h>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/new_image.h"

namespace synth {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSize = 16384;                           // px, of an image and of a tile
constexpr std::size_t kMaxMemory = std::size_t{1} << 28;  // bytes that a file may ask for at once

/// The first part of a file, as OpenEXR's reader in C reads it from memory. That in C++ believes
/// the sizes that a header states.
class File {
 public:
  /// Throws vo::Error unless the headers are sound.
  File(const std::string& bytes, const fs::path& path) : bytes_(bytes), path_(path) {
    exr_context_initializer_t reader = EXR_DEFAULT_CONTEXT_INITIALIZER;
    reader.user_data = this;
    reader.size_fn = size_of;
    reader.read_fn = read;
    reader.error_handler_fn = keep_complaint;
    reader.alloc_fn = allocate;
    reader.free_fn = std::free;
    reader.max_image_width = reader.max_image_height = kMaxSize;
    reader.max_tile_width = reader.max_tile_height = kMaxSize;
    const exr_result_t result = exr_start_read(&context_, path.c_str(), &reader);
    if (result != EXR_ERR_SUCCESS) {
      exr_finish(&context_);
    }
    check(result);
  }
  ~File() { exr_finish(&context_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  File(File&&) = delete;
  File& operator=(File&&) = delete;

  exr_const_context_t context() const { return context_; }
  const fs::path& path() const { return path_; }

  /// Throws vo::Error with what OpenEXR complained of, if anything.
  void check(exr_result_t result) const {
    if (result == EXR_ERR_OUT_OF_MEMORY) {
      vo::fail_as(vo::ErrorKind::temporary, path_.string(), ": there is not enough memory for it");
    }
    if (result != EXR_ERR_SUCCESS) {
      vo::fail(path_.string(), ": expected an image of linear light in OpenEXR's format (.exr): ",
               complaint_.empty() ? exr_get_default_error_message(result) : complaint_);
    }
  }

 private:
  static std::int64_t size_of(exr_const_context_t /*context*/, void* file) {
    return static_cast<std::int64_t>(static_cast<File*>(file)->bytes_.size());
  }

  static std::int64_t read(exr_const_context_t /*context*/, void* file, void* to,
                           std::uint64_t count, std::uint64_t at,
                           exr_stream_error_func_ptr_t /*complain*/) {
    const std::string& bytes = static_cast<File*>(file)->bytes_;
    const std::size_t begin = std::min<std::size_t>(at, bytes.size());
    const std::size_t length = std::min<std::size_t>(count, bytes.size() - begin);
    std::memcpy(to, bytes.data() + begin, length);
    return static_cast<std::int64_t>(length);
  }

  static void keep_complaint(exr_const_context_t context, exr_result_t /*code*/, const char* text) {
    void* file = nullptr;
    if (exr_get_user_data(context, &file) == EXR_ERR_SUCCESS && file != nullptr) {
      static_cast<File*>(file)->complaint_ = text;
    }
  }

  static void* allocate(std::size_t size) {
    return size > kMaxMemory ? nullptr : std::malloc(size);
  }

  const std::string& bytes_;
  const fs::path& path_;
  std::string complaint_;
  exr_context_t context_ = nullptr;
};

/// The channels of the image that is made, 0 to 2, by their names in the file.
using Colors = std::map<std::string, int>;

/// Returns red, green and blue, or brightness for the first.
Colors colors_of(const File& file) {
  const exr_attr_chlist_t* channels = nullptr;
  file.check(exr_get_channels(file.context(), 0, &channels));
  std::string names;
  Colors colors;
  Colors brightness;
  for (int i = 0; i < channels->num_channels; ++i) {
    const exr_attr_chlist_entry_t& channel = channels->entries[i];
    const std::string name = channel.name.str;
    names += (names.empty() ? "" : ", ") + name;
    if (name == "R" || name == "G" || name == "B" || name == "Y") {
      vo::require(channel.x_sampling == 1 && channel.y_sampling == 1, file.path().string(),
                  ": has channel ", name, " of fewer pixels than the image, expected all of them");
      (name == "Y" ? brightness : colors)[name] = name == "G" ? 1 : name == "B" ? 2 : 0;
    }
  }
  vo::require(colors.size() == 3 || !brightness.empty(), file.path().string(),
              ": has the channels ", names.empty() ? "none" : names, ", expected R, G and B, or Y");
  return colors.size() == 3 ? colors : brightness;
}

/// Decodes chunks, which are tiles or some rows, into an image.
class Decoder {
 public:
  Decoder(const File& file, const Colors& colors, cv::Mat_<cv::Vec3f>& image)
      : file_(file), colors_(colors), image_(image) {}
  ~Decoder() { exr_decoding_destroy(file_.context(), &pipeline_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  Decoder(Decoder&&) = delete;
  Decoder& operator=(Decoder&&) = delete;

  /// Decodes a chunk whose first pixel is `corner`.
  void decode(const exr_chunk_info_t& chunk, cv::Point corner) {
    const std::uint64_t most = std::max(chunk.packed_size, chunk.unpacked_size);
    const std::uint64_t least = std::min(chunk.packed_size, chunk.unpacked_size);
    vo::require(least > 0 && most <= kMaxMemory, file_.path().string(), ": has a chunk of ",
                chunk.packed_size, " bytes that holds ", chunk.unpacked_size, ", expected 1 to ",
                kMaxMemory);
    const bool is_first = pipeline_.channels == nullptr;
    file_.check(is_first ? exr_decoding_initialize(file_.context(), 0, &chunk, &pipeline_)
                         : exr_decoding_update(file_.context(), 0, &chunk, &pipeline_));
    vo::require(corner.x + chunk.width <= image_.cols && corner.y + chunk.height <= image_.rows,
                file_.path().string(), ": has pixels beyond its image");
    for (int i = 0; i < pipeline_.channel_count; ++i) {
      set_target(pipeline_.channels[i], chunk, corner);
    }
    if (is_first) {
      file_.check(exr_decoding_choose_default_routines(file_.context(), 0, &pipeline_));
    }
    file_.check(exr_decoding_run(file_.context(), 0, &pipeline_));
  }

 private:
  /// Lets a channel be decoded into the image; one that is not wanted, into memory of its own,
  /// since OpenEXR 3.1.5 writes some of those, too, that are said to have no place.
  void set_target(exr_coding_channel_info_t& channel, const exr_chunk_info_t& chunk,
                  cv::Point corner) {
    const auto color = colors_.find(channel.channel_name);
    const bool is_wanted = color != colors_.end();
    unwanted_.resize(static_cast<std::size_t>(chunk.width) *
                     static_cast<std::size_t>(chunk.height));
    float* first = is_wanted ? &image_(corner)[color->second] : unwanted_.data();
    channel.decode_to_ptr = reinterpret_cast<std::uint8_t*>(first);
    channel.user_data_type = EXR_PIXEL_FLOAT;
    channel.user_bytes_per_element = sizeof(float);
    channel.user_pixel_stride = is_wanted ? sizeof(cv::Vec3f) : sizeof(float);
    channel.user_line_stride = is_wanted ? static_cast<std::int32_t>(image_.step[0])
                                         : chunk.width * static_cast<std::int32_t>(sizeof(float));
  }

  const File& file_;
  const Colors& colors_;
  cv::Mat_<cv::Vec3f>& image_;
  std::vector<float> unwanted_;
  exr_decode_pipeline_t pipeline_ = EXR_DECODE_PIPELINE_INITIALIZER;
};

void decode_rows(const File& file, int first_row, int rows, Decoder& decoder) {
  int step = 0;
  file.check(exr_get_scanlines_per_chunk(file.context(), 0, &step));
  for (int v = 0; v < rows; v += step) {
    exr_chunk_info_t chunk{};
    file.check(exr_read_scanline_chunk_info(file.context(), 0, first_row + v, &chunk));
    decoder.decode(chunk, {0, v});
  }
}

void decode_tiles(const File& file, cv::Size size, Decoder& decoder) {
  int width = 0;
  int height = 0;
  file.check(exr_get_tile_sizes(file.context(), 0, 0, 0, &width, &height));
  for (int v = 0; v < size.height; v += height) {
    for (int u = 0; u < size.width; u += width) {
      exr_chunk_info_t chunk{};
      file.check(exr_read_tile_chunk_info(file.context(), 0, u / width, v / height, 0, 0, &chunk));
      decoder.decode(chunk, {u, v});
    }
  }
}

exr_storage_t storage_of(const File& file) {
  exr_storage_t storage = EXR_STORAGE_SCANLINE;
  file.check(exr_get_storage(file.context(), 0, &storage));
  return storage;
}

void require_readable_panorama(const File& file) {
  const exr_storage_t storage = storage_of(file);
  vo::require(storage == EXR_STORAGE_SCANLINE || storage == EXR_STORAGE_TILED, file.path().string(),
              ": has a list of samples in each pixel, expected an image");
  exr_compression_t compression = EXR_COMPRESSION_NONE;
  file.check(exr_get_compression(file.context(), 0, &compression));
  vo::require(compression != EXR_COMPRESSION_DWAA && compression != EXR_COMPRESSION_DWAB,
              file.path().string(),
              ": is compressed by DWA, which OpenEXR's reader in C leaves out, expected none, RLE, "
              "ZIP, PIZ, PXR24 or B44");
  exr_envmap_t kind = EXR_ENVMAP_LATLONG;
  const exr_result_t result = exr_attr_get_envmap(file.context(), 0, "envmap", &kind);
  vo::require(result != EXR_ERR_SUCCESS || kind == EXR_ENVMAP_LATLONG, file.path().string(),
              ": is a cube map, expected an equirectangular image");
}

cv::Mat_<cv::Vec3f> decode(const File& file) {
  require_readable_panorama(file);
  const Colors colors = colors_of(file);
  exr_attr_box2i_t window{};
  file.check(exr_get_data_window(file.context(), 0, &window));
  const cv::Size size(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
  cv::Mat_<cv::Vec3f> image = vo::new_light_image(size, file.path());
  Decoder decoder(file, colors, image);
  if (storage_of(file) == EXR_STORAGE_TILED) {
    decode_tiles(file, size, decoder);
  } else {
    decode_rows(file, window.min.y, size.height, decoder);
  }
  if (colors.size() == 1) {
    for (cv::Vec3f& light : image) {
      light = {light[0], light[0], light[0]};
    }
  }
  return image;
}

/// Sets negative light to 0. Throws vo::Error naming the first pixel that is no finite number.
void keep_light(cv::Mat_<cv::Vec3f>& image, const fs::path& path) {
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      cv::Vec3f& light = image(v, u);
      for (const int channel : {0, 1, 2}) {
        vo::require(std::isfinite(light[channel]), path.string(), ": pixel ", u, ", ", v, " is ",
                    light[channel], ", expected finite numbers");
        light[channel] = std::max(light[channel], 0.0F);
      }
    }
  }
}

}  // namespace

cv::Mat_<cv::Vec3f> read_exr(const fs::path& path) {
  const std::string bytes = vo::read_file(path);
  cv::Mat_<cv::Vec3f> image = decode(File(bytes, path));
  keep_light(image, path);
  return image;
}

}  // namespace synth
