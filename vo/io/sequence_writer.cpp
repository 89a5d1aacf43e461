#include <array>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>

#include "vo/core/error.h"
#include "vo/io/camera_file.h"
#include "vo/io/npy.h"
#include "vo/io/output.h"
#include "vo/io/png.h"
#include "vo/io/sequence.h"
#include "vo/io/trajectory_file.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

std::string file_name(const char* folder, std::size_t index, const char* extension) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "%s/%06zu.%s", folder, index, extension);
  return name.data();
}

/// Depth beyond what 16 bits hold is written as "no measurement".
cv::Mat_<std::uint16_t> quantised(const DepthImage& depth, double units_per_m) {
  constexpr double kMaxUnits = 65534;
  cv::Mat_<std::uint16_t> units(depth.size());
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const double value = std::round(depth(v, u) * units_per_m);
      units(v, u) = value >= 0 && value <= kMaxUnits ? static_cast<std::uint16_t>(value) : 0;
    }
  }
  return units;
}

std::string format_list(const char* title, const char* folder, const char* extension,
                        const Trajectory& truth) {
  std::string text = concat("# ", title, "\n# timestamp filename\n");
  for (std::size_t i = 0; i < truth.size(); ++i) {
    text += format_timestamp(truth[i].timestamp) + " " + file_name(folder, i, extension) + "\n";
  }
  return text;
}

}  // namespace

std::string format_timestamp(double timestamp) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.6f", timestamp);
  return text.data();
}

SequenceWriter::SequenceWriter(fs::path folder, const RgbdCamera& camera, FloatDepth float_depth)
    : folder_(std::move(folder)), camera_(camera), float_depth_(float_depth) {
  for (const char* name : {"rgb", "depth", "depth_float"}) {
    std::error_code error;
    if (name != std::string("depth_float") || float_depth == FloatDepth::npy) {
      fs::create_directories(folder_ / name, error);
    }
    require(!error, (folder_ / name).string(), ": cannot be made: ", error.message());
  }
}

void SequenceWriter::write_frame(std::size_t index, const RgbdFrame& frame) const {
  write_file(folder_ / file_name("rgb", index, "png"), encode_png(frame.image));
  write_file(folder_ / file_name("depth", index, "png"),
             encode_png(quantised(frame.depth, camera_.depth_units_per_m)));
  if (float_depth_ == FloatDepth::npy) {
    write_file(folder_ / file_name("depth_float", index, "npy"), encode_npy(frame.depth));
  }
}

void SequenceWriter::finish(const Trajectory& truth) const {
  write_file(folder_ / "rgb.txt", format_list("colour images, sRGB", "rgb", "png", truth));
  write_file(folder_ / "depth.txt",
             format_list("planar depth at pixel centres, 16 bit", "depth", "png", truth));
  if (float_depth_ == FloatDepth::npy) {
    write_file(folder_ / "depth_float.txt",
               format_list("planar depth at pixel centres, m", "depth_float", "npy", truth));
  }
  write_file(folder_ / "groundtruth.txt", format_trajectory(truth));
  write_file(folder_ / "camera.toml", format_camera(camera_));
}

}  // namespace vo
