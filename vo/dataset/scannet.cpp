#include "vo/dataset/scannet.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/frame_files.h"
#include "vo/dataset/frame_images.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/image_file.h"
#include "vo/motion_files/pose_matrix.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr double kScannerRate = 30;       // Hz
constexpr double kMillimetres = 1000;     // depth units per m
constexpr double kNoDifferencePx = 0.05;  // between two cameras that need not be told apart

/// Reads a camera's matrix; it has no size.
PinholeCamera read_intrinsics(const fs::path& path) {
  const Eigen::Matrix4d K = read_matrix(path);
  require(K.allFinite() && K(0, 0) > 0 && K(1, 1) > 0, path.string(),
          ": expected a camera's matrix with focal lengths above 0");
  return {0, 0, K(0, 0), K(1, 1), K(0, 2), K(1, 2)};
}

/// Returns the depth camera of a folder, of the size of its first frame: of depth, else of colour.
RgbdCamera read_depth_camera(const fs::path& folder, const FrameFiles& first) {
  const cv::Size size =
      first.depth.empty() ? read_byte_image(first.image).size() : read_image(first.depth).size();
  RgbdCamera camera{
      read_intrinsics(folder / "intrinsic" /
                      (first.depth.empty() ? "intrinsic_color.txt" : "intrinsic_depth.txt")),
      kMillimetres};
  camera.pinhole.width = size.width;
  camera.pinhole.height = size.height;
  return camera;
}

/// Returns the camera of images that are scaled to this size.
PinholeCamera scaled_to(const PinholeCamera& camera, cv::Size from, cv::Size to) {
  const double x = static_cast<double>(to.width) / from.width;
  const double y = static_cast<double>(to.height) / from.height;
  return {to.width,
          to.height,
          x * camera.fx,
          y * camera.fy,
          x * (camera.cx + 0.5) - 0.5,
          y * (camera.cy + 0.5) - 0.5};
}

/// Returns the greatest distance, px, between what two cameras of one size see at a pixel.
double greatest_difference(const PinholeCamera& a, const PinholeCamera& b) {
  double greatest = 0;
  for (const double u : {0.0, a.width - 1.0}) {
    for (const double v : {0.0, a.height - 1.0}) {
      const Eigen::Vector2d pixel(u, v);
      greatest = std::max(greatest, (b.project(a.unproject(pixel, 1)) - pixel).norm());
    }
  }
  return greatest;
}

/// Returns an image of the colour camera as the depth camera, which shares its centre, would see
/// it.
cv::Mat seen_by(const PinholeCamera& depth, const PinholeCamera& color, const cv::Mat& image) {
  const cv::Size size(depth.width, depth.height);
  if (image.size() == size) {
    return image;
  }
  cv::Mat result;
  cv::resize(image, result, size, 0, 0, cv::INTER_AREA);
  const PinholeCamera scaled = scaled_to(color, image.size(), size);
  if (greatest_difference(depth, scaled) > kNoDifferencePx) {
    const double x = scaled.fx / depth.fx;
    const double y = scaled.fy / depth.fy;
    const cv::Matx23d to_color(x, 0, scaled.cx - x * depth.cx, 0, y, scaled.cy - y * depth.cy);
    cv::Mat warped;
    cv::warpAffine(result, warped, to_color, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REPLICATE);
    return warped;
  }
  return result;
}

/// Appends a note where the colour camera does not share the depth camera's centre.
void check_extrinsics(const fs::path& folder, std::vector<std::string>& notes) {
  for (const char* name : {"extrinsic_color.txt", "extrinsic_depth.txt"}) {
    const fs::path path = folder / "intrinsic" / name;
    if (fs::exists(path) && !read_matrix(path).isIdentity(1e-3)) {
      notes.push_back(path.string() +
                      ": is not the identity, which is not applied: depth is taken as registered "
                      "to colour");
    }
  }
}

}  // namespace

SequenceSource open_scannet(const fs::path& folder, const std::optional<RgbdCamera>& camera) {
  const std::vector<NumberedFile> images = numbered_files(folder, "color", {});
  const std::vector<FrameFiles> frames =
      paired_files(images, numbered_files(folder, "depth", {"", "", ".png"}), kScannerRate);
  require(!frames.empty(), folder.string(), ": expected color/0.jpg");
  SequenceSource source;
  source.camera = camera || fs::exists(folder / "camera.toml")
                      ? camera_of_folder(folder, camera, {})
                      : checked_camera(read_depth_camera(folder, frames.front()),
                                       folder / "intrinsic/intrinsic_depth.txt");
  const PinholeCamera color = read_intrinsics(folder / "intrinsic/intrinsic_color.txt");
  check_extrinsics(folder, source.notes);
  source.timestamps = stamps_of(frames);
  source.read = [frames, color, camera = source.camera](std::size_t index) {
    const FrameFiles& files = frames.at(index);
    RgbdFrame frame{
        files.timestamp, seen_by(camera.pinhole, color, read_byte_image(files.image)), {}};
    if (!files.depth.empty()) {
      frame.depth = read_depth_png(files.depth, camera);
    }
    return frame;
  };
  source.truth =
      poses_of_images(numbered_files(folder, "pose", {"", "", ".txt"}), images, kScannerRate);
  return source;
}

}  // namespace vo
