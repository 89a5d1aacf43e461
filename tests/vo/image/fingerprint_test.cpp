#include "vo/image/fingerprint.h"

#include <gtest/gtest.h>

#include "vo/core/hash.h"
#include "vo/core/image.h"

namespace {

vo::ByteImage noise(int rows, int columns) {
  vo::ByteImage image(rows, columns);
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      image(v, u) = static_cast<uchar>(vo::mixed(static_cast<std::uint64_t>(v * columns + u)));
    }
  }
  return image;
}

TEST(Fingerprint, IsThatOfTheBytesWhereverTheyLie) {
  const vo::ByteImage image = noise(40, 61);
  const vo::ByteImage part = image(cv::Rect(3, 5, 37, 20));
  EXPECT_EQ(vo::fingerprint(part), vo::fingerprint(part.clone()));
  EXPECT_NE(vo::fingerprint(part), vo::fingerprint(image(cv::Rect(4, 5, 37, 20))));
  EXPECT_EQ(vo::fingerprint(cv::Mat()), 0U);
}

TEST(Fingerprint, ChangesWithEveryByte) {
  vo::ByteImage image = noise(7, 45);
  const std::uint64_t before = vo::fingerprint(image);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image(v, u) = static_cast<uchar>(image(v, u) + 1);
      EXPECT_NE(vo::fingerprint(image), before) << u << ", " << v;
      image(v, u) = static_cast<uchar>(image(v, u) - 1);
    }
  }
  EXPECT_EQ(vo::fingerprint(image), before);
}

}  // namespace
