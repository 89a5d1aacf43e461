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

std::string segment(char marker, const std::string& data) {
  const std::size_t length = data.size() + 2;
  const std::string head{'\xFF', marker, static_cast<char>(length >> 8U),
                         static_cast<char>(length & 0xFFU)};
  return head + data;
}

/// Returns a progressive JPEG (ITU T.81, G) of one grey block: a scan of its mean, and scans that
/// say each that nothing else is in it.
std::vector<std::uint8_t> of_scans(int number) {
  const auto table = [](char place, char symbol) {  // of one code, 0
    return segment('\xC4', std::string(1, place) + '\1' + std::string(15, '\0') + symbol);
  };
  const std::string size{8, 0, 8, 0, 8, 1, 1, 0x11, 0};
  std::string jpeg = "\xFF\xD8" + segment('\xDB', std::string(1, '\0') + std::string(64, '\1')) +
                     segment('\xC2', size) + table('\x00', '\0') + table('\x10', '\0') +
                     segment('\xDA', {1, 1, 0, 0, 0, 0}) + '\x7F';
  for (int scan = 1; scan < number; ++scan) {
    jpeg += segment('\xDA', {1, 1, 0, 1, 63, 0}) + '\x7F';
  }
  jpeg += "\xFF\xD9";
  return {jpeg.begin(), jpeg.end()};
}

TEST(JpegCodec, InksOfAPrintAreNamed) {
  std::vector<std::uint8_t> jpeg = of_scans(1);
  const auto after_signature = jpeg.begin() + 2;
  const std::string adobe = segment('\xEE', {'A', 'd', 'o', 'b', 'e', 0, 100, 0, 0, 0, 0, 0});
  jpeg.insert(after_signature, adobe.begin(), adobe.end());
  const std::string one_component{8, 0, 8, 0, 8, 1, 1, 0x11, 0};
  const auto frame =
      std::search(jpeg.begin(), jpeg.end(), one_component.begin(), one_component.end());
  ASSERT_NE(frame, jpeg.end());
  const std::string inks{2, 0x11, 0, 3, 0x11, 0, 4, 0x11, 0};
  *(frame - 1) = 8 + 3 * 4;  // the segment's length
  *(frame + 5) = 4;
  jpeg.insert(frame + static_cast<std::ptrdiff_t>(one_component.size()), inks.begin(), inks.end());
  EXPECT_THAT(support::error_text([&] {
                vo::decode_jpeg(jpeg, {8, 8});
              }),
              testing::HasSubstr("CMYK, expected grey or colour"));
}

TEST(JpegCodec, ScansWithoutEndAreAnError) {
  EXPECT_EQ(vo::decode_jpeg(of_scans(500), {8, 8})(4, 4), cv::Vec3b(128, 128, 128));
  EXPECT_THAT(support::error_text([] {
                vo::decode_jpeg(of_scans(501), {8, 8});
              }),
              testing::HasSubstr("500 scans"));
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
