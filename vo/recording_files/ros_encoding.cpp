#include "vo/recording_files/ros_encoding.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>

#include "vo/core/error.h"
#include "vo/core/nanoseconds.h"
#include "vo/recording_files/byte_writer.h"
#include "vo/recording_files/message_cursor.h"

namespace vo {
namespace {

constexpr std::uint8_t kFloat32 = 7;  // PointField's number of the type

/// Writes the fields of a message in their order.
class CdrWriter {
 public:
  template <typename Number>
  void number(Number value) {
    align(sizeof(Number));
    append_number(bytes_, value);
  }

  template <typename Numbers>
  void numbers(const Numbers& values) {
    for (const double value : values) {
      number(value);
    }
  }

  void string(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    bytes_ += text;
    bytes_ += '\0';
  }

  void bytes(std::string_view part) {
    number(static_cast<std::uint32_t>(part.size()));
    bytes_ += part;
  }

  void header(const RosHeader& header) {
    const std::int64_t rest =  // of a second that began before, also before 1970
        (header.stamp_ns % kNanosecondsPerSecond + kNanosecondsPerSecond) % kNanosecondsPerSecond;
    number(static_cast<std::int32_t>((header.stamp_ns - rest) / kNanosecondsPerSecond));
    number(static_cast<std::uint32_t>(rest));
    string(header.frame_id);
  }

  const std::string& result() const { return bytes_; }

 private:
  void align(std::size_t size) {
    const std::size_t over = (bytes_.size() - kCdrEncapsulation) % size;
    bytes_.append(over == 0 ? 0 : size - over, '\0');
  }

  std::string bytes_{"\0\1\0\0", kCdrEncapsulation};
};

/// The fields of a type, in the language of .msg files, and the types that they are of.
struct Definition {
  std::string fields;
  std::vector<std::string> uses;
};

const std::map<std::string, Definition>& definitions() {
  static const std::map<std::string, Definition> types = {
      {"builtin_interfaces/Time", {"int32 sec\nuint32 nanosec\n", {}}},
      {"std_msgs/Header",
       {"builtin_interfaces/Time stamp\nstring frame_id\n", {"builtin_interfaces/Time"}}},
      {"geometry_msgs/Point", {"float64 x\nfloat64 y\nfloat64 z\n", {}}},
      {"geometry_msgs/Vector3", {"float64 x\nfloat64 y\nfloat64 z\n", {}}},
      {"geometry_msgs/Quaternion", {"float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n", {}}},
      {"geometry_msgs/Pose",
       {"geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n",
        {"geometry_msgs/Point", "geometry_msgs/Quaternion"}}},
      {"geometry_msgs/PoseStamped",
       {"std_msgs/Header header\ngeometry_msgs/Pose pose\n",
        {"std_msgs/Header", "geometry_msgs/Pose"}}},
      {"geometry_msgs/Transform",
       {"geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n",
        {"geometry_msgs/Vector3", "geometry_msgs/Quaternion"}}},
      {"geometry_msgs/TransformStamped",
       {"std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n",
        {"std_msgs/Header", "geometry_msgs/Transform"}}},
      {"tf2_msgs/TFMessage",
       {"geometry_msgs/TransformStamped[] transforms\n", {"geometry_msgs/TransformStamped"}}},
      {"sensor_msgs/Image",
       {"std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\n"
        "uint8 is_bigendian\nuint32 step\nuint8[] data\n",
        {"std_msgs/Header"}}},
      {"sensor_msgs/RegionOfInterest",
       {"uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify\n", {}}},
      {"sensor_msgs/CameraInfo",
       {"std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\n"
        "float64[] d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\nuint32 binning_x\n"
        "uint32 binning_y\nsensor_msgs/RegionOfInterest roi\n",
        {"std_msgs/Header", "sensor_msgs/RegionOfInterest"}}},
      {"sensor_msgs/PointField",
       {"string name\nuint32 offset\nuint8 datatype\nuint32 count\n", {}}},
      {"sensor_msgs/PointCloud2",
       {"std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\n"
        "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n",
        {"std_msgs/Header", "sensor_msgs/PointField"}}},
  };
  return types;
}

/// Appends the types that a type uses, each once.
void append_uses(std::string& text, const std::string& type, std::set<std::string>& seen) {
  for (const std::string& use : definitions().at(type).uses) {
    if (seen.insert(use).second) {
      text += std::string(80, '=') + "\nMSG: " + use + "\n" + definitions().at(use).fields;
      append_uses(text, use, seen);
    }
  }
}

}  // namespace

std::string encode_cdr(const RosImage& image) {
  CdrWriter writer;
  writer.header(image.header);
  writer.number(image.height);
  writer.number(image.width);
  writer.string(image.encoding);
  writer.number(static_cast<std::uint8_t>(image.is_bigendian ? 1 : 0));
  writer.number(image.step);
  writer.bytes(image.data);
  return writer.result();
}

std::string encode_cdr(const RosCameraInfo& info) {
  constexpr int kBinningAndRegion = 2 + 4;  // no binning, the whole image
  CdrWriter writer;
  writer.header(info.header);
  writer.number(info.height);
  writer.number(info.width);
  writer.string(info.distortion_model);
  writer.number(static_cast<std::uint32_t>(info.D.size()));
  writer.numbers(info.D);
  writer.numbers(info.K);
  writer.numbers(info.R);
  writer.numbers(info.P);
  for (int i = 0; i < kBinningAndRegion; ++i) {
    writer.number(std::uint32_t{0});
  }
  writer.number(std::uint8_t{0});  // the region is not rectified
  return writer.result();
}

std::string encode_cdr(const RosPointCloud& cloud) {
  CdrWriter writer;
  const auto point_step = static_cast<std::uint32_t>(sizeof(float) * cloud.fields.size());
  const auto points = static_cast<std::uint32_t>(cloud.data.size() / point_step);
  writer.header(cloud.header);
  writer.number(std::uint32_t{1});  // rows
  writer.number(points);
  writer.number(static_cast<std::uint32_t>(cloud.fields.size()));
  std::uint32_t offset = 0;
  for (const std::string& field : cloud.fields) {
    writer.string(field);
    writer.number(offset);
    writer.number(kFloat32);
    writer.number(std::uint32_t{1});
    offset += static_cast<std::uint32_t>(sizeof(float));
  }
  writer.number(std::uint8_t{0});  // little endian
  writer.number(point_step);
  writer.number(point_step * points);
  writer.bytes(cloud.data);
  writer.number(std::uint8_t{1});  // every point is one
  return writer.result();
}

std::string encode_pose_stamped(const RosPose& pose) {
  CdrWriter writer;
  writer.header(pose.header);
  writer.numbers(pose.position);
  writer.numbers(pose.rotation);
  return writer.result();
}

std::string encode_tf(const std::vector<RosPose>& transforms) {
  CdrWriter writer;
  writer.number(static_cast<std::uint32_t>(transforms.size()));
  for (const RosPose& transform : transforms) {
    writer.header(transform.header);
    writer.string(transform.child_frame_id);
    writer.numbers(transform.position);
    writer.numbers(transform.rotation);
  }
  return writer.result();
}

std::string ros2_definition(const std::string& type) {
  std::string name = type;
  if (const std::size_t at = name.find("/msg/"); at != std::string::npos) {
    name.erase(at, 4);
  }
  const auto found = definitions().find(name);
  require(found != definitions().end(), type, ": is not written");
  std::string text = found->second.fields;
  std::set<std::string> seen;
  append_uses(text, name, seen);
  return text;
}

}  // namespace vo
