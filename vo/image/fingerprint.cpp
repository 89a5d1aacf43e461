#include "vo/image/fingerprint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "vo/core/hash.h"

namespace vo {

namespace {

using Words = std::array<std::uint64_t, 4>;

/// Four hashes side by side, which the processor computes at once: each takes every fourth word of
/// 64 bits. Each step is a bijection of the hash, so that two rows that differ in one word differ.
class WordHashes {
 public:
  void add(const Words& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      hashes_[i] = std::rotl((hashes_[i] ^ words[i]) * 0x9e3779b97f4a7c15U, 29);
    }
  }

  std::uint64_t mixed_together() const {
    std::uint64_t hash = 0;
    for (const std::uint64_t part : hashes_) {
      hash = mixed(hash ^ part);
    }
    return hash;
  }

 private:
  Words hashes_{1, 2, 3, 4};
};

}  // namespace

std::uint64_t fingerprint(const cv::Mat& image) {
  if (image.empty()) {
    return 0;
  }
  WordHashes hashes;
  const std::size_t row_bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
  for (int v = 0; v < image.rows; ++v) {
    const uchar* row = image.ptr(v);
    for (std::size_t at = 0; at < row_bytes; at += sizeof(Words)) {
      Words words{};
      std::memcpy(words.data(), row + at, std::min(sizeof(Words), row_bytes - at));
      hashes.add(words);
    }
  }
  return hashes.mixed_together();
}

}  // namespace vo
