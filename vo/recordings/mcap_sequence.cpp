#include "vo/recordings/mcap_sequence.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "vo/core/error.h"
#include "vo/files/streamed_output.h"
#include "vo/frames/depth_timestamp.h"
#include "vo/frames/depth_units.h"
#include "vo/motion_files/timestamp.h"
#include "vo/recording_files/byte_writer.h"
#include "vo/recording_files/ros_encoding.h"
#include "vo/recordings/camera_message.h"

namespace vo {
namespace {

constexpr const char* kWorldFrame = "world";
constexpr const char* kCameraFrame = "camera_color_optical_frame";
constexpr double kUnitsPerMetre = 1000;  // of 16-bit depth, as ROS has it

RosImage image_message(const RosHeader& header, const cv::Mat& image, const std::string& encoding) {
  RosImage message{.header = header};
  message.height = static_cast<std::uint32_t>(image.rows);
  message.width = static_cast<std::uint32_t>(image.cols);
  message.encoding = encoding;
  message.step = static_cast<std::uint32_t>(image.cols * static_cast<int>(image.elemSize()));
  message.data = {reinterpret_cast<const char*>(image.data), image.total() * image.elemSize()};
  return message;
}

std::string encode_colour(const RosHeader& header, const cv::Mat& image) {
  const cv::Mat whole = image.isContinuous() ? image : image.clone();
  return encode_cdr(image_message(header, whole, image.channels() == 3 ? "bgr8" : "mono8"));
}

/// Encodes depth in mm where that is exact.
std::string encode_depth(const RosHeader& header, const DepthImage& depth) {
  const cv::Mat_<std::uint16_t> units = to_depth_units(depth, kUnitsPerMetre);
  const DepthImage back = from_depth_units(units, kUnitsPerMetre);
  if (std::equal(depth.begin(), depth.end(), back.begin())) {
    return encode_cdr(image_message(header, units, "16UC1"));
  }
  const cv::Mat whole = depth.isContinuous() ? depth : depth.clone();
  return encode_cdr(image_message(header, whole, "32FC1"));
}

std::string encode_cloud(const RosHeader& header, const RgbdFrame& frame,
                         const PinholeCamera& camera) {
  RosPointCloud cloud{.header = header, .fields = {"x", "y", "z", "rgb"}};
  for (int v = 0; v < frame.depth.rows; ++v) {
    for (int u = 0; u < frame.depth.cols; ++u) {
      if (!has_depth(frame.depth(v, u))) {
        continue;
      }
      const Eigen::Vector3f p_camera = camera.unproject({u, v}, frame.depth(v, u)).cast<float>();
      const bool is_grey = frame.image.channels() == 1;
      const cv::Vec3b bgr =
          is_grey ? cv::Vec3b::all(frame.image.at<uchar>(v, u)) : frame.image.at<cv::Vec3b>(v, u);
      append_number(cloud.data, p_camera.x());
      append_number(cloud.data, p_camera.y());
      append_number(cloud.data, p_camera.z());
      // PCL's and RViz' convention: the bytes b, g, r, 0 of what is declared a float.
      append_number(cloud.data,
                    static_cast<std::uint32_t>(bgr[0] | (bgr[1] << 8) | (bgr[2] << 16)));
    }
  }
  return encode_cdr(cloud);
}

RosPose pose_message(std::int64_t stamp_ns, const SE3& T_world_camera) {
  const Eigen::Vector3d& t = T_world_camera.translation();
  const Eigen::Quaterniond& q = T_world_camera.rotation();
  return {
      {stamp_ns, kWorldFrame}, kCameraFrame, {t.x(), t.y(), t.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

/// Writes the messages of a sequence in the order of time. Those of a frame are logged at the
/// image's stamp; the headers of its depth have the depth's own.
class SequenceMessages {
 public:
  SequenceMessages(McapWriter& writer, const SequenceSource& source, PointClouds clouds)
      : writer_(writer), source_(source), clouds_(clouds) {
    image_ = add("/camera/color/image_raw", "sensor_msgs/msg/Image");
    info_ = add("/camera/color/camera_info", "sensor_msgs/msg/CameraInfo");
    depth_ = add("/camera/aligned_depth_to_color/image_raw", "sensor_msgs/msg/Image");
    depth_info_ = add("/camera/aligned_depth_to_color/camera_info", "sensor_msgs/msg/CameraInfo");
    if (clouds == PointClouds::written) {
      cloud_ = add("/camera/aligned_depth_to_color/points", "sensor_msgs/msg/PointCloud2");
    }
    pose_ = add("/camera/pose", "geometry_msgs/msg/PoseStamped");
    tf_ = add("/tf", "tf2_msgs/msg/TFMessage");
  }

  void write_frame(const RgbdFrame& frame) {
    const std::int64_t stamp_ns = to_nanoseconds(frame.timestamp);
    write_poses_until(stamp_ns);
    const RosHeader header{stamp_ns, kCameraFrame};
    RosCameraInfo info = camera_info_of(source_.camera.pinhole);
    info.header = header;
    writer_.write(info_, stamp_ns, encode_cdr(info));
    writer_.write(image_, stamp_ns, encode_colour(header, frame.image));
    if (frame.depth.empty()) {
      return;
    }
    const RosHeader depth_header{to_nanoseconds(depth_timestamp(frame)), kCameraFrame};
    info.header = depth_header;
    writer_.write(depth_info_, stamp_ns, encode_cdr(info));
    writer_.write(depth_, stamp_ns, encode_depth(depth_header, frame.depth));
    if (clouds_ == PointClouds::written) {
      writer_.write(cloud_, stamp_ns, encode_cloud(depth_header, frame, source_.camera.pinhole));
    }
  }

  /// Writes the poses of the truth up to a stamp.
  void write_poses_until(std::int64_t stamp_ns) {
    for (; next_pose_ < source_.truth.size(); ++next_pose_) {
      const StampedPose& pose = source_.truth[next_pose_];
      const std::int64_t pose_ns = to_nanoseconds(pose.timestamp);
      if (pose_ns > stamp_ns) {
        break;
      }
      const RosPose message = pose_message(pose_ns, pose.T_world_camera);
      writer_.write(pose_, pose_ns, encode_pose_stamped(message));
      writer_.write(tf_, pose_ns, encode_tf({message}));
    }
  }

 private:
  std::uint16_t add(const char* name, const char* type) {
    return writer_.add_topic(name, type, ros2_definition(type));
  }

  McapWriter& writer_;
  const SequenceSource& source_;
  PointClouds clouds_;
  std::size_t next_pose_ = 0;
  std::uint16_t image_ = 0;
  std::uint16_t info_ = 0;
  std::uint16_t depth_ = 0;
  std::uint16_t depth_info_ = 0;
  std::uint16_t cloud_ = 0;
  std::uint16_t pose_ = 0;
  std::uint16_t tf_ = 0;
};

}  // namespace

void require_mcap_stamps(const SequenceSource& source, const std::string& place) {
  constexpr double kMost = 2147483647;  // s, of 31 bits
  const auto require_stamp = [&](double timestamp) {
    require(timestamp >= 0 && timestamp < kMost, place, ": MCAP: expected stamps from 0 to ", kMost,
            " s, got ", timestamp);
  };
  for (const double timestamp : source.timestamps) {
    require_stamp(timestamp);
  }
  for (const StampedPose& pose : source.truth) {
    require_stamp(pose.timestamp);
  }
}

void write_mcap_sequence(const std::filesystem::path& path, const SequenceSource& source,
                         const McapLayout& layout, PointClouds clouds, const OutputPolicy& policy,
                         const Progress& progress) {
  StreamedOutput output(path, policy);
  McapWriter writer([&](std::string_view bytes) { output.append(bytes); }, layout);
  SequenceMessages messages(writer, source, clouds);
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    messages.write_frame(source.read(i));
    progress(i + 1, source.timestamps.size());
  }
  messages.write_poses_until(std::numeric_limits<std::int64_t>::max());
  writer.finish();
  output.commit();
}

}  // namespace vo
