#include "vo/image_files/png.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/output.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::EndsWith;
using testing::HasSubstr;

/// Pixels that use all bits of the type.
cv::Mat pattern(int type) {
  cv::Mat image(37, 53, type);
  for (int v = 0; v < image.rows; ++v) {
    auto* row = image.ptr<uchar>(v);
    for (std::size_t i = 0; i < static_cast<std::size_t>(image.cols) * image.elemSize(); ++i) {
      row[i] = static_cast<uchar>(v * 31 + static_cast<int>(i) * 7 + static_cast<int>(i * i) / 5);
    }
  }
  return image;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() &&
         std::equal(a.datastart, a.dataend, b.datastart, b.dataend);
}

TEST(Png, ReadInvertsEncode) {
  const TempFolder folder;
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC1}) {
    const cv::Mat image = pattern(type);
    vo::write_file(folder.path() / "image.png", vo::encode_png(image), vo::ExistingOutput::replace);
    EXPECT_TRUE(same(vo::read_png(folder.path() / "image.png"), image)) << "type " << type;
  }
}

TEST(Png, EveryTruncationIsAnErrorThatNamesTheFile) {
  const TempFolder folder;
  const std::string bytes = vo::encode_png(pattern(CV_8UC3));
  const auto path = folder.path() / "cut.png";
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 8) {
    vo::write_file(path, bytes.substr(0, size), vo::ExistingOutput::replace);
    EXPECT_THAT(error_text([&] { vo::read_png(path); }), HasSubstr("cut.png: ")) << size;
  }
  EXPECT_THAT(error_text([&] { vo::read_png(path); }), EndsWith("it is truncated"));
}

TEST(Png, ADamagedByteIsAnError) {
  const TempFolder folder;
  std::string bytes = vo::encode_png(pattern(CV_16UC1));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  vo::write_file(folder.path() / "bad.png", bytes);
  EXPECT_THAT(error_text([&] { vo::read_png(folder.path() / "bad.png"); }),
              HasSubstr("bad.png: cannot be decoded: "));
}

TEST(Png, ASizeThatTheFileCannotHoldIsRefusedBeforeMemoryIsAskedFor) {
  const TempFolder folder;
  std::string bytes = vo::encode_png(pattern(CV_8UC3));
  constexpr std::size_t kWidth = 16;     // after the signature and the length and name of the chunk
  constexpr std::size_t kChecksum = 29;  // after the 13 bytes of the header
  for (const std::size_t at : {kWidth, kWidth + 4}) {
    bytes.replace(at, 4, std::string("\0\0\x3e\x80", 4));  // 16000
  }
  const auto checksum =
      ::crc32(0, reinterpret_cast<const unsigned char*>(bytes.data()) + kWidth - 4, 17);
  for (std::size_t i = 0; i < 4; ++i) {
    bytes[kChecksum + i] = static_cast<char>(checksum >> (24 - 8 * i) & 0xff);
  }
  vo::write_file(folder.path() / "huge.png", bytes);
  EXPECT_THAT(error_text([&] { vo::read_png(folder.path() / "huge.png"); }),
              EndsWith(" bytes, too few for 16000x16000 px"));
}

std::string big_endian(std::size_t number) {
  return {static_cast<char>(number >> 24U & 0xFFU), static_cast<char>(number >> 16U & 0xFFU),
          static_cast<char>(number >> 8U & 0xFFU), static_cast<char>(number & 0xFFU)};
}

/// Returns a chunk as the PNG specification has it (5.3): length, name, data, CRC-32 of the two.
std::string chunk(const std::string& name, const std::string& data) {
  const std::string text = name + data;
  const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
  return big_endian(data.size()) + text +
         big_endian(::crc32(0, bytes, static_cast<unsigned>(text.size())));
}

/// A PNG of one row, of which libpng has written nothing.
std::string png_of_row(std::size_t width, char bits, char colour_type, const std::string& row,
                       const std::string& chunks = "") {
  const std::string filtered = std::string(1, '\0') + row;
  std::string pixels(::compressBound(filtered.size()), '\0');
  auto size = static_cast<uLongf>(pixels.size());
  EXPECT_EQ(::compress(reinterpret_cast<Bytef*>(pixels.data()), &size,
                       reinterpret_cast<const Bytef*>(filtered.data()), filtered.size()),
            Z_OK);
  const std::string header =
      big_endian(width) + big_endian(1) + std::string{bits, colour_type, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunks +
         chunk("IDAT", pixels.substr(0, size)) + chunk("IEND", "");
}

TEST(Png, MorePixelsThanItCanHaveAreNotDecompressed) {
  const std::string png = png_of_row(1, 8, 0, std::string(100'000'000, '\0'));
  EXPECT_THAT(error_text([&] { vo::decode_png(png, "a.png"); }),
              testing::MatchesRegex(
                  "a.png: cannot be decoded: it has [0-9]+ bytes of pixels, too many for 1x1 px"));
}

constexpr char kGrey = 0;
constexpr char kColour = 2;
constexpr char kPalette = 3;
constexpr char kColourAndAlpha = 6;

TEST(PngRgba, HasTheChannelsOfColourRedFirst) {
  EXPECT_EQ(vo::decode_png_rgba(png_of_row(1, 8, kColourAndAlpha, "\1\2\3\4"), "a.png")(0, 0),
            cv::Vec4b(1, 2, 3, 4));
  EXPECT_EQ(vo::decode_png_rgba(png_of_row(1, 8, kColour, "\1\2\3"), "a.png")(0, 0),
            cv::Vec4b(1, 2, 3, 255));
}

TEST(PngRgba, SpreadsBitsOfGrey) {
  const cv::Mat_<cv::Vec4b> rgba =
      vo::decode_png_rgba(png_of_row(4, 2, kGrey, "\x1B"), "a.png");  // 0, 1, 2, 3
  for (int u = 0; u < 4; ++u) {
    const auto grey = static_cast<uchar>(85 * u);
    EXPECT_EQ(rgba(0, u), cv::Vec4b(grey, grey, grey, 255));
  }
}

TEST(PngRgba, RoundsEverySixteenBitValue) {
  constexpr int kStep = 4;  // as an image has at most 16384 columns
  for (int first = 0; first < kStep; ++first) {
    std::string row;
    for (int value = first; value < 65536; value += kStep) {
      row += {static_cast<char>(value >> 8), static_cast<char>(value & 0xFF)};
    }
    const cv::Mat_<cv::Vec4b> rgba =
        vo::decode_png_rgba(png_of_row(65536 / kStep, 16, kGrey, row), "a.png");
    for (int value = first; value < 65536; value += kStep) {
      ASSERT_EQ(rgba(0, value / kStep)[0], std::lround(value / 257.0)) << value;
    }
  }
}

TEST(PngRgba, ResolvesAPaletteAndItsTransparency) {
  const std::string transparency("\0\x80", 2);  // of the first two colours
  const std::string png = png_of_row(
      3, 2, kPalette, "\x18",
      chunk("PLTE", "\x0A\x14\x1E\x28\x32\x3C\x46\x50\x5A") + chunk("tRNS", transparency));
  const cv::Mat_<cv::Vec4b> rgba = vo::decode_png_rgba(png, "a.png");
  ASSERT_EQ(rgba.size(), cv::Size(3, 1));
  EXPECT_EQ(rgba(0, 0), cv::Vec4b(10, 20, 30, 0));
  EXPECT_EQ(rgba(0, 1), cv::Vec4b(40, 50, 60, 128));
  EXPECT_EQ(rgba(0, 2), cv::Vec4b(70, 80, 90, 255));
}

TEST(Png, WhatIsNoPngSaysSo) {
  const TempFolder folder;
  vo::write_file(folder.path() / "text.png", "this is no image at all");
  EXPECT_THAT(error_text([&] { vo::read_png(folder.path() / "text.png"); }),
              EndsWith("text.png: is not a PNG image"));
  EXPECT_THAT(error_text([&] { vo::read_png(folder.path() / "none.png"); }),
              EndsWith("none.png: there is no such file"));
}

}  // namespace
