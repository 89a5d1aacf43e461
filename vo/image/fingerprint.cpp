#include "vo/image/fingerprint.h"

#include <array>
#include <cstring>

#include "vo/core/hash.h"

namespace vo {
namespace {

constexpr std::size_t kLanes = 8;  // independent sums, so that multiplications overlap
constexpr std::size_t kWord = sizeof(std::uint64_t);

using Lanes = std::array<std::uint64_t, kLanes>;

void add_row(const unsigned char* row, std::size_t bytes, Lanes& lanes) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15ULL;
  std::size_t at = 0;
  for (; at + kLanes * kWord <= bytes; at += kLanes * kWord) {
    Lanes words;
    std::memcpy(words.data(), row + at, sizeof(words));
    for (std::size_t k = 0; k < kLanes; ++k) {
      lanes[k] = (lanes[k] ^ words[k]) * kOdd;
      lanes[k] ^= lanes[k] >> 32U;
    }
  }
  for (; at < bytes; ++at) {
    lanes[0] = (lanes[0] ^ row[at]) * kOdd;
  }
}

}  // namespace

std::uint64_t fingerprint(const cv::Mat& image) {
  if (image.empty()) {
    return 0;
  }
  Lanes lanes{1, 2, 3, 4, 5, 6, 7, 8};
  for (int v = 0; v < image.rows; ++v) {
    add_row(image.ptr(v), static_cast<std::size_t>(image.cols) * image.elemSize(), lanes);
  }
  std::uint64_t result = 0;
  for (const std::uint64_t lane : lanes) {
    result = mixed(result ^ lane);
  }
  return result;
}

}  // namespace vo
