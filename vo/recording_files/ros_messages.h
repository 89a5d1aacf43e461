#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// The messages of ROS that recordings of cameras hold, as far as they are used. `data` of images
/// is part of the bytes that were parsed. All functions throw Error for bytes that end early or are
/// of another `encoding` than RecordedTopic's `cdr` and `ros1`.

/// std_msgs/Header.
struct RosHeader {
  std::int64_t stamp_ns = 0;
  std::string frame_id;  ///< the frame of coordinates, without a slash in front
};

/// sensor_msgs/Image.
struct RosImage {
  RosHeader header;
  std::uint32_t height = 0;  ///< px
  std::uint32_t width = 0;   ///< px
  std::string encoding;      ///< as `rgb8`
  bool is_bigendian = false;
  std::uint32_t step = 0;  ///< bytes of a row
  std::string_view data;
};

/// sensor_msgs/CompressedImage.
struct RosCompressedImage {
  RosHeader header;
  std::string format;  ///< as `jpeg` or `16UC1; compressedDepth png`
  std::string_view data;
};

/// sensor_msgs/CameraInfo, as far as it is about the lens and the whole image.
struct RosCameraInfo {
  RosHeader header;
  std::uint32_t height = 0;      ///< px
  std::uint32_t width = 0;       ///< px
  std::string distortion_model;  ///< as `plumb_bob`
  std::vector<double> D;         ///< coefficients of the distortion
  std::array<double, 9> K{};     ///< intrinsics of the image as it is, row by row
  std::array<double, 9> R{};     ///< rotation to the rectified camera, row by row
  std::array<double, 12> P{};    ///< projection of the rectified image, row by row
};

/// A pose or transform: of `child_frame_id` in the frame of the header.
struct RosPose {
  RosHeader header;
  std::string child_frame_id;        ///< empty where the message does not name it
  std::array<double, 3> position{};  ///< m
  std::array<double, 4> rotation{};  ///< quaternion x, y, z, w
};

/// sensor_msgs/PointCloud2 in which every field is a float of 32 bits, without rows.
struct RosPointCloud {
  RosHeader header;
  std::vector<std::string> fields;  ///< names, as `x`
  std::string data;                 ///< the fields of each point behind each other
};

/// Returns the stamp, ns, of a message that begins with a header, by its first 64 bytes or more.
std::int64_t parse_stamp(std::string_view bytes, std::string_view encoding);

RosImage parse_image(std::string_view bytes, std::string_view encoding);
RosCompressedImage parse_compressed_image(std::string_view bytes, std::string_view encoding);
RosCameraInfo parse_camera_info(std::string_view bytes, std::string_view encoding);

/// Returns whether messages of a type, as RecordedTopic has it, hold poses: PoseStamped,
/// PoseWithCovarianceStamped, TransformStamped, Odometry, TFMessage.
bool holds_poses(std::string_view type);

/// Returns the poses that a message of such a type holds, one unless it is a TFMessage.
std::vector<RosPose> parse_poses(std::string_view bytes, std::string_view encoding,
                                 std::string_view type);

}  // namespace vo
