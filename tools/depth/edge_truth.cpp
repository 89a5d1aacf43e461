#include "tools/depth/edge_truth.h"

#include <filesystem>

#include "vo/core/error.h"
#include "vo/image_files/png.h"

namespace tools {

synth::EdgeLabels true_edges(const vo::SequenceReader& sequence, std::size_t frame) {
  const std::filesystem::path image = sequence.image_file(frame);
  if (image.empty()) {
    return {};
  }
  const std::filesystem::path file =
      image.parent_path().parent_path() / "truth/edges" / image.stem().concat(".png");
  if (!std::filesystem::exists(file)) {
    return {};
  }
  cv::Mat labels = vo::read_png(file);
  const vo::PinholeCamera& camera = sequence.camera().pinhole;
  vo::require(labels.type() == CV_8UC1 && labels.size() == cv::Size(camera.width, camera.height),
              file, ": expected 8 bit labels of ", camera.width, "x", camera.height, " px");
  return labels;
}

}  // namespace tools
