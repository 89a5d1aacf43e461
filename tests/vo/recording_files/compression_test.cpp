#include "vo/recording_files/compression.h"

#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

using support::error_text;
using testing::HasSubstr;

std::string some_bytes() {
  std::string bytes;
  for (std::uint32_t i = 0; i < 3'000'000; ++i) {
    bytes += static_cast<char>(i * i >> 9);
  }
  return bytes;
}

TEST(Compression, GivesTheBytesBack) {
  const std::string bytes = some_bytes();
  for (const auto compression :
       {vo::Compression::none, vo::Compression::lz4, vo::Compression::zstd}) {
    const std::string stored = vo::compress(compression, bytes);
    EXPECT_TRUE(vo::decompress(compression, stored, bytes.size()) == bytes);
    EXPECT_THAT(error_text([&] { vo::decompress(compression, stored, bytes.size() - 1); }),
                HasSubstr("stated"));
    EXPECT_THAT(error_text([&] { vo::decompress(compression, stored, bytes.size() + 1); }),
                HasSubstr("stated"));
  }
}

TEST(Compression, OfDamagedBytesIsAnError) {
  const std::string bytes = some_bytes();
  for (const auto compression : {vo::Compression::lz4, vo::Compression::zstd}) {
    const std::string stored = vo::compress(compression, bytes);
    EXPECT_THAT(error_text([&] {
                  vo::decompress(compression, stored.substr(0, stored.size() / 2), bytes.size());
                }),
                HasSubstr("ends within its compressed data"));
    EXPECT_THAT(error_text([&] { vo::decompress(compression, "no frame", 8); }),
                HasSubstr("is damaged"));
  }
  EXPECT_THAT(error_text([&] { vo::decompress(vo::Compression::bz2, "no stream", 8); }),
              HasSubstr("is damaged"));
}

TEST(Compression, StatedSizesAreNotAskedForAtOnce) {
  const std::string stored = vo::compress(vo::Compression::zstd, "few");
  EXPECT_THAT(
      error_text([&] { vo::decompress(vo::Compression::zstd, stored, std::size_t{1} << 50); }),
      HasSubstr("holds 3 bytes"));
}

TEST(Compression, Bzip2IsReadAndNotWritten) {
  // These are the bytes that the program bzip2 makes of "bzip2 is read\n".
  const std::string stored(
      "BZh91AY&"
      "SY\x3c\x52\x03\xfd\x00\x00\x02\xd9\x80\x00\x10\x40\x00\x10\x00\x36\x20\x58\x10\x20\x00\x22"
      "\x1a\x00\x68\x40\xd0\x34\x25\xfb\x72\x6f\x8e\x90\x0f\x8b\xb9\x22\x9c\x28\x48\x1e\x29\x01\xfe"
      "\x80",
      56);
  EXPECT_EQ(vo::decompress(vo::Compression::bz2, stored, 14), "bzip2 is read\n");
  EXPECT_THAT(error_text([&] { vo::compress(vo::Compression::bz2, "x"); }),
              HasSubstr("bzip2 is not written"));
}

}  // namespace
