#include "vo/dataset/seven_scenes.h"

#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/frame_files.h"
#include "vo/dataset/frame_images.h"

namespace vo {
namespace {

constexpr double kKinectRate = 30;  // Hz
constexpr const char* kFrame = "frame-";

}  // namespace

bool holds_seven_scenes(const std::filesystem::path& folder) {
  return std::filesystem::is_directory(folder) &&
         !numbered_files(folder, "", {kFrame, ".color", ""}).empty();
}

SequenceSource open_seven_scenes(const std::filesystem::path& folder,
                                 const std::optional<RgbdCamera>& camera) {
  const std::vector<NumberedFile> images = numbered_files(folder, "", {kFrame, ".color", ""});
  const std::vector<FrameFiles> frames =
      paired_files(images, numbered_files(folder, "", {kFrame, ".depth", ".png"}), kKinectRate);
  require(!frames.empty(), folder.string(), ": expected frame-000000.color.png");
  SequenceSource source;
  source.camera = camera_of_folder(folder, camera, load_camera("7-scenes"));
  source.timestamps = stamps_of(frames);
  source.read = [frames, camera = source.camera](std::size_t index) {
    return read_frame(frames.at(index), camera);
  };
  source.truth =
      poses_of_images(numbered_files(folder, "", {kFrame, ".pose", ".txt"}), images, kKinectRate);
  return source;
}

}  // namespace vo
