#pragma once

#include <string>
#include <string_view>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/recording_files/recording_index.h"

namespace vo {

/// What the images of a topic show.
enum class ImageKind {
  colour,
  grey,
  depth,
  unread  ///< in an encoding that is not read
};

/// An image message, but for its pixels.
struct ImageTraits {
  ImageKind kind = ImageKind::unread;
  cv::Size size;         ///< px; 0 where it is not read
  std::string encoding;  ///< as `rgb8`, or the format of a compressed image
  std::string frame_id;
};

/// Returns whether a type is one of image messages: sensor_msgs/Image or CompressedImage.
bool holds_images(std::string_view type);

/// Returns what an image message of a topic is. `place` begins errors, as in all of these.
ImageTraits image_traits(std::string_view message, const RecordedTopic& topic,
                         const std::string& place);

/// Decodes an image of 8 bits: grey (CV_8UC1) or colour (CV_8UC3, BGR); alpha is dropped. Throws
/// Error for an encoding that is not read and for sizes that the message does not hold.
cv::Mat decode_image(std::string_view message, const RecordedTopic& topic,
                     const std::string& place);

/// Decodes depth, m: of 16 bits in units of 1 / `units_per_m`, in which 0 and 65535 are none, or of
/// floats in m, in which what is not finite or not above 0 is none; compressedDepth likewise.
DepthImage decode_depth(std::string_view message, const RecordedTopic& topic, double units_per_m,
                        const std::string& place);

}  // namespace vo
