#include "vo/dataset/frame_images.h"

#include <cmath>

#include "vo/core/error.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/image_file.h"
#include "vo/image_files/npy.h"

namespace vo {

cv::Mat read_byte_image(const std::filesystem::path& path) {
  cv::Mat image = read_image(path);
  require(image.depth() == CV_8U, path.string(), ": expected 8 bits per channel, got 16");
  return image;
}

cv::Mat read_frame_image(const std::filesystem::path& path, const PinholeCamera& camera) {
  cv::Mat image = read_byte_image(path);
  require_size(image, camera, path);
  return image;
}

RgbdFrame read_frame(const FrameFiles& files, const RgbdCamera& camera) {
  RgbdFrame frame{files.timestamp, read_frame_image(files.image, camera.pinhole), {}};
  if (!files.depth.empty()) {
    frame.depth = files.depth.extension() == ".npy" ? read_depth_npy(files.depth, camera.pinhole)
                                                    : read_depth_png(files.depth, camera);
  }
  return frame;
}

DepthImage read_depth_npy(const std::filesystem::path& path, const PinholeCamera& camera) {
  const cv::Mat image = read_npy(path);
  require_size(image, camera, path);
  require(image.channels() == 1, path.string(), ": expected depth in one channel, got ",
          image.channels());
  DepthImage depth = image;
  for (float& value : depth) {
    value = std::isfinite(value) && value > 0 ? value : 0;
  }
  return depth;
}

}  // namespace vo
