#include "vo/dataset/colour_sequence.h"

#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/sequence.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/timestamp.h"

namespace vo {

std::vector<NamedBytes> encode_colour_frame(std::size_t index, const RgbdFrame& frame) {
  return {{frame_file("rgb", index, "png"), encode_png(frame.image)}};
}

std::vector<NamedBytes> encode_colour_lists(const RgbdCameraModel& camera,
                                            const std::vector<double>& timestamps) {
  return {{"rgb.txt", format_image_list("colour images, sRGB", "rgb", "png", timestamps)},
          {"camera.toml", format_camera(camera)}};
}

std::string format_image_list(const std::string& title, const char* folder, const char* extension,
                              const std::vector<double>& timestamps) {
  const std::vector<std::string> stamps = format_timestamps(timestamps);
  std::string text = concat("# ", title, "\n# timestamp filename\n");
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    text += stamps[i] + " " + frame_file(folder, i, extension) + "\n";
  }
  return text;
}

}  // namespace vo
