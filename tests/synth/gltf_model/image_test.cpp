#include "synth/gltf_model/image.h"

#include <algorithm>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "vo/core/error.h"
#include "vo/image_files/jpeg_codec.h"
#include "vo/image_files/png.h"

namespace {

/// A smooth picture, whose JPEG at high quality differs little.
vo::ColorImage smooth_picture() {
  vo::ColorImage image(48, 64);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image(v, u) = {static_cast<uchar>(3 * u), static_cast<uchar>(4 * v),
                     static_cast<uchar>(2 * u + 2 * v)};
    }
  }
  return image;
}

std::vector<std::uint8_t> encoded() {
  return vo::encode_jpeg(smooth_picture(), 95, vo::ChromaSampling::full);
}

TEST(JpegCodec, GivesBackASmoothPicture) {
  const vo::ColorImage image = smooth_picture();
  const vo::ColorImage decoded = vo::decode_jpeg(encoded(), image.size());
  EXPECT_LT(cv::norm(image, decoded, cv::NORM_INF), 8);
  EXPECT_LT(cv::norm(image, decoded, cv::NORM_L1) / (3.0 * 64 * 48), 1.5);
}

TEST(JpegCodec, RefusesAnotherSize) {
  EXPECT_THROW(vo::decode_jpeg(encoded(), {64, 49}), vo::Error);
}

TEST(JpegCodec, TexturesAreItsPixelsWithRedFirst) {
  const vo::ColorImage decoded = vo::decode_jpeg(encoded(), {64, 48});
  const cv::Mat_<cv::Vec4b> texture = synth::decode_image(encoded(), "a.jpg");
  ASSERT_EQ(texture.size(), decoded.size());
  const cv::Vec3b bgr = decoded(30, 20);
  EXPECT_EQ(texture(30, 20), cv::Vec4b(bgr[2], bgr[1], bgr[0], 255));
}

/// Huffman tables that claim more codes than there can be: stb_image wrote beyond its own.
TEST(JpegCodec, DamagedHuffmanTablesAreAnError) {
  std::vector<std::uint8_t> bytes = encoded();
  constexpr std::array<std::uint8_t, 2> kHuffmanTable{0xFF, 0xC4};
  const auto table =
      std::search(bytes.begin(), bytes.end(), kHuffmanTable.begin(), kHuffmanTable.end());
  ASSERT_NE(table, bytes.end());
  std::fill_n(table + 5, 16, std::uint8_t{0xFF});
  EXPECT_THROW(synth::decode_image(bytes, "a.jpg"), vo::Error);
}

/// stb_image asked for 2 GB, as the header of a chunk of pixels states, whatever the file holds.
TEST(PngTexture, WithAnAbsurdChunkIsAnError) {
  const std::string png = vo::encode_png(smooth_picture());
  std::vector<std::uint8_t> bytes(png.begin(), png.end());
  constexpr std::array<std::uint8_t, 4> kPixels{'I', 'D', 'A', 'T'};
  const auto chunk = std::search(bytes.begin(), bytes.end(), kPixels.begin(), kPixels.end());
  ASSERT_NE(chunk, bytes.end());
  std::fill_n(chunk - 4, 4, std::uint8_t{0x3F});
  EXPECT_THAT(support::error_text([&] { synth::decode_image(bytes, "a.png"); }),
              testing::StartsWith("a.png: cannot be decoded, expected an undamaged PNG (PNG: "));
}

}  // namespace
