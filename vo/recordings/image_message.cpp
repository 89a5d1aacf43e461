#include "vo/recordings/image_message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "vo/core/error.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/jpeg_codec.h"
#include "vo/image_files/new_image.h"
#include "vo/image_files/png.h"
#include "vo/recording_files/byte_cursor.h"
#include "vo/recording_files/ros_messages.h"

namespace vo {
namespace {

/// An encoding of sensor_msgs/Image.
struct PixelEncoding {
  std::string_view name;
  ImageKind kind;
  int type;  ///< as OpenCV has it
  bool is_rgb = false;
};

constexpr std::array kEncodings = {
    PixelEncoding{"rgb8", ImageKind::colour, CV_8UC3, true},
    PixelEncoding{"bgr8", ImageKind::colour, CV_8UC3},
    PixelEncoding{"8UC3", ImageKind::colour, CV_8UC3},
    PixelEncoding{"rgba8", ImageKind::colour, CV_8UC4, true},
    PixelEncoding{"bgra8", ImageKind::colour, CV_8UC4},
    PixelEncoding{"mono8", ImageKind::grey, CV_8UC1},
    PixelEncoding{"8UC1", ImageKind::grey, CV_8UC1},
    PixelEncoding{"16UC1", ImageKind::depth, CV_16UC1},
    PixelEncoding{"mono16", ImageKind::depth, CV_16UC1},
    PixelEncoding{"32FC1", ImageKind::depth, CV_32FC1},
};

const PixelEncoding* find_encoding(std::string_view name) {
  const auto found =
      std::find_if(kEncodings.begin(), kEncodings.end(),
                   [&](const PixelEncoding& encoding) { return encoding.name == name; });
  return found == kEncodings.end() ? nullptr : found;
}

std::string known_encodings() {
  std::string text;
  for (const PixelEncoding& encoding : kEncodings) {
    text += (text.empty() ? "" : ", ") + std::string(encoding.name);
  }
  return text;
}

/// Returns the pixels of an image as they are in the message, which must outlive them.
cv::Mat pixels_of(const RosImage& image, const PixelEncoding& encoding, const std::string& place) {
  constexpr std::uint32_t kMaxSize = 16384;  // px
  require(
      image.width >= 1 && image.width <= kMaxSize && image.height >= 1 && image.height <= kMaxSize,
      place, ": expected an image of 1 to ", kMaxSize, " px in width and height, got ", image.width,
      "x", image.height);
  const std::size_t row = image.width * static_cast<std::size_t>(CV_ELEM_SIZE(encoding.type));
  require(image.step >= row, place, ": has rows of ", image.step, " bytes, expected ", row,
          " or more");
  require(image.data.size() >= (image.height - std::size_t{1}) * image.step + row, place, ": has ",
          image.data.size(), " bytes of pixels, expected ", image.height, " rows of ", image.step);
  require(!image.is_bigendian || CV_ELEM_SIZE1(encoding.type) == 1, place,
          ": has pixels in big endian, expected little endian");
  // OpenCV's matrix of what is not its own has no const, but it is only read.
  return {static_cast<int>(image.height), static_cast<int>(image.width), encoding.type,
          const_cast<char*>(image.data.data()), image.step};
}

bool is_compressed(const RecordedTopic& topic) {
  return topic.type == "sensor_msgs/CompressedImage";
}

bool is_compressed_depth(const RosCompressedImage& image) {
  return image.format.find("compressedDepth") != std::string::npos;
}

/// Calls; an Error begins with the place unless it does already.
template <typename Parse>
auto parsed_at(const std::string& place, Parse parse) {
  try {
    return parse();
  } catch (const Error& error) {
    throw Error(concat(place, ": ", error.what()), error.kind());
  }
}

RosImage image_of(std::string_view message, const RecordedTopic& topic, const std::string& place) {
  return parsed_at(place, [&] { return parse_image(message, topic.encoding); });
}

RosCompressedImage compressed_image_of(std::string_view message, const RecordedTopic& topic,
                                       const std::string& place) {
  return parsed_at(place, [&] { return parse_compressed_image(message, topic.encoding); });
}

cv::Mat decode_compressed(const RosCompressedImage& image, const std::string& place) {
  if (is_png(image.data)) {
    return decode_png(image.data, place);
  }
  require(is_jpeg(image.data), place, ": is compressed as '", image.format,
          "', expected jpeg or png");
  return decode_jpeg(image.data, place);
}

/// Depth as image_transport's compressedDepth has it: a head, and a PNG of 16 bits.
struct CompressedDepth {
  float a = 0;  ///< depth in m is a / (value - b), where floats were compressed
  float b = 0;
  cv::Mat values;
  bool is_inverse = false;  ///< floats were compressed
};

CompressedDepth decode_compressed_depth(const RosCompressedImage& image, const std::string& place) {
  CompressedDepth depth{.is_inverse = image.format.starts_with("32FC1")};
  require(depth.is_inverse || image.format.starts_with("16UC1"), place, ": is compressed as '",
          image.format, "', expected 16UC1 or 32FC1");
  std::string_view png;
  parsed_at(place, [&] {
    ByteCursor cursor(image.data);
    cursor.take(sizeof(std::uint32_t));  // the kind of compression, which the format names, too
    depth.a = cursor.number<float>();
    depth.b = cursor.number<float>();
    png = cursor.take(cursor.left());
    return 0;
  });
  require(is_png(png), place, ": is compressed as '", image.format, "', expected png");
  depth.values = decode_png(png, place);
  require(depth.values.type() == CV_16UC1, place, ": expected depth of 16 bits in one channel");
  return depth;
}

DepthImage only_measured(DepthImage depth) {
  for (float& value : depth) {
    value = std::isfinite(value) && value > 0 ? value : 0;
  }
  return depth;
}

DepthImage from_inverse(const CompressedDepth& depth) {
  DepthImage metres(depth.values.size());
  std::transform(depth.values.begin<std::uint16_t>(), depth.values.end<std::uint16_t>(),
                 metres.begin(), [&](std::uint16_t value) {
                   return value == 0 ? 0.0F : depth.a / (static_cast<float>(value) - depth.b);
                 });
  return only_measured(std::move(metres));
}

ImageTraits compressed_traits(const RosCompressedImage& image, const std::string& place) {
  ImageTraits traits{.encoding = image.format, .frame_id = image.header.frame_id};
  try {
    const cv::Mat pixels = is_compressed_depth(image) ? decode_compressed_depth(image, place).values
                                                      : decode_compressed(image, place);
    traits.size = pixels.size();
    traits.kind = pixels.depth() == CV_16U ? ImageKind::depth
                  : pixels.channels() == 1 ? ImageKind::grey
                                           : ImageKind::colour;
  } catch (const Error&) {
    traits.kind = ImageKind::unread;
  }
  return traits;
}

}  // namespace

bool holds_images(std::string_view type) {
  return type == "sensor_msgs/Image" || type == "sensor_msgs/CompressedImage";
}

ImageTraits image_traits(std::string_view message, const RecordedTopic& topic,
                         const std::string& place) {
  if (is_compressed(topic)) {
    return compressed_traits(compressed_image_of(message, topic, place), place);
  }
  const RosImage image = image_of(message, topic, place);
  const PixelEncoding* encoding = find_encoding(image.encoding);
  ImageTraits traits{.encoding = image.encoding, .frame_id = image.header.frame_id};
  if (encoding != nullptr) {
    traits.kind = encoding->kind;
    traits.size = pixels_of(image, *encoding, place).size();
  }
  return traits;
}

cv::Mat decode_image(std::string_view message, const RecordedTopic& topic,
                     const std::string& place) {
  if (is_compressed(topic)) {
    cv::Mat pixels = decode_compressed(compressed_image_of(message, topic, place), place);
    require(pixels.depth() == CV_8U, place, ": expected 8 bits per channel, got 16");
    return pixels;
  }
  const RosImage image = image_of(message, topic, place);
  const PixelEncoding* encoding = find_encoding(image.encoding);
  require(encoding != nullptr && encoding->kind != ImageKind::depth, place, ": is encoded as '",
          image.encoding, "', expected one of ", known_encodings(), " with 8 bits");
  const cv::Mat pixels = pixels_of(image, *encoding, place);
  if (encoding->type == CV_8UC1 || (encoding->type == CV_8UC3 && !encoding->is_rgb)) {
    return pixels.clone();
  }
  cv::Mat colour = new_image(pixels.size(), CV_8UC3, place);
  constexpr std::array kFromRgb = {2, 0, 1, 1, 0, 2};
  constexpr std::array kFromBgr = {0, 0, 1, 1, 2, 2};
  cv::mixChannels(&pixels, 1, &colour, 1, (encoding->is_rgb ? kFromRgb : kFromBgr).data(), 3);
  return colour;
}

DepthImage decode_depth(std::string_view message, const RecordedTopic& topic, double units_per_m,
                        const std::string& place) {
  if (is_compressed(topic)) {
    const RosCompressedImage image = compressed_image_of(message, topic, place);
    if (is_compressed_depth(image)) {
      const CompressedDepth depth = decode_compressed_depth(image, place);
      return depth.is_inverse ? from_inverse(depth) : from_depth_units(depth.values, units_per_m);
    }
    const cv::Mat values = decode_compressed(image, place);
    require(values.type() == CV_16UC1, place, ": expected depth of 16 bits in one channel");
    return from_depth_units(values, units_per_m);
  }
  const RosImage image = image_of(message, topic, place);
  const PixelEncoding* encoding = find_encoding(image.encoding);
  require(encoding != nullptr && encoding->kind == ImageKind::depth, place, ": is encoded as '",
          image.encoding, "', expected depth as 16UC1, mono16 or 32FC1");
  const cv::Mat pixels = pixels_of(image, *encoding, place);
  return encoding->type == CV_16UC1 ? from_depth_units(pixels, units_per_m)
                                    : only_measured(DepthImage(pixels.clone()));
}

}  // namespace vo
