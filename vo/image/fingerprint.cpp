#include "vo/image/fingerprint.h"

#include "vo/core/content_hash.h"

namespace vo {

std::uint64_t fingerprint(const cv::Mat& image) {
  std::uint64_t hash = 0;
  for (int v = 0; v < image.rows; ++v) {
    const std::size_t bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
    hash = continued_hash({image.ptr<char>(v), bytes}, hash);
  }
  return hash;
}

}  // namespace vo
