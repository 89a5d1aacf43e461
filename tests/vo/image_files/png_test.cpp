#include "vo/image_files/png.h"

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

TEST(Png, WhatIsNoPngSaysSo) {
  const TempFolder folder;
  vo::write_file(folder.path() / "text.png", "this is no image at all");
  EXPECT_THAT(error_text([&] { vo::read_png(folder.path() / "text.png"); }),
              EndsWith("text.png: is not a PNG image"));
  EXPECT_THAT(error_text([&] { vo::read_png(folder.path() / "none.png"); }),
              EndsWith("none.png: there is no such file"));
}

}  // namespace
