#include <array>
#include <cstdio>

#include "vo/core/error.h"
#include "vo/dataset/colour_sequence.h"
#include "vo/dataset/sequence.h"
#include "vo/frames/depth_units.h"
#include "vo/geometry/associate.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {
namespace {

std::vector<double> delayed(std::vector<double> timestamps, double delay) {
  for (double& timestamp : timestamps) {
    timestamp += delay;
  }
  return timestamps;
}

}  // namespace

std::string frame_number(std::size_t index) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%06zu", index);
  return number.data();
}

std::string frame_file(const std::string& folder, std::size_t index, const std::string& extension) {
  return folder + "/" + frame_number(index) + "." + extension;
}

std::vector<std::string> frame_files(const SequenceLayout& layout, std::size_t index) {
  std::vector<std::string> files = {frame_file("rgb", index, "png"),
                                    frame_file("depth", index, "png")};
  if (layout.float_depth == FloatDepth::npy) {
    files.push_back(frame_file("depth_float", index, "npy"));
  }
  return files;
}

std::vector<NamedBytes> encode_frame(const SequenceLayout& layout, std::size_t index,
                                     const RgbdFrame& frame) {
  const std::vector<std::string> names = frame_files(layout, index);
  std::vector<NamedBytes> files = {
      {names[0], encode_png(frame.image)},
      {names[1], encode_png(to_depth_units(frame.depth, layout.camera.depth_units_per_m))}};
  if (layout.float_depth == FloatDepth::npy) {
    files.push_back({names[2], encode_npy(frame.depth)});
  }
  return files;
}

std::vector<NamedBytes> encode_image_lists(const SequenceLayout& layout,
                                           const std::vector<double>& timestamps,
                                           const std::vector<double>& depth_stamps) {
  const std::string depth = layout.camera.model.has_optical_axis()
                                ? "planar depth at pixel centres"
                                : "distance along the rays of pixel centres";
  std::vector<NamedBytes> files = encode_colour_lists(layout.camera, timestamps);
  files.insert(files.begin() + 1,
               {"depth.txt", format_image_list(depth + ", 16 bit", "depth", "png", depth_stamps)});
  if (layout.float_depth == FloatDepth::npy) {
    files.insert(
        files.begin() + 2,
        {"depth_float.txt", format_image_list(depth + ", m", "depth_float", "npy", depth_stamps)});
  }
  return files;
}

std::vector<NamedBytes> encode_lists(const SequenceLayout& layout, const Trajectory& truth) {
  const std::vector<double> timestamps = timestamps_of(truth);
  std::vector<NamedBytes> files =
      encode_image_lists(layout, timestamps, delayed(timestamps, layout.depth_delay));
  files.push_back({"groundtruth.txt", format_trajectory(truth)});
  return files;
}

}  // namespace vo
