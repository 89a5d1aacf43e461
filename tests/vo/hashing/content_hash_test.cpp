#include "vo/hashing/content_hash.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

TEST(ContentHash, IsXxh3) {
  // The empty input's hash of xxHash's specification, as the program xxh128sum prints it.
  EXPECT_EQ(vo::content_hash(""), "99aa06d3014798d86001c324468d497f");
}

TEST(ContentHash, TellsBytesAndNotHowTheyWereAdded) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) {
    bytes += static_cast<char>(i * i);
  }
  for (const std::size_t part : {std::size_t{1}, std::size_t{17}, std::size_t{500}}) {
    vo::ContentHash hash;
    for (std::size_t at = 0; at < bytes.size(); at += part) {
      hash.add(std::string_view(bytes).substr(at, part));
    }
    EXPECT_EQ(hash.hex(), vo::content_hash(bytes)) << part;
  }
  EXPECT_NE(vo::content_hash("a"), vo::content_hash("b"));
}

TEST(ContentHash, PlainValuesAreTheirBytes) {
  const std::vector<std::uint32_t> values{0x04030201U, 0x08070605U};
  vo::ContentHash hash;
  hash.add_values(std::span<const std::uint32_t>(values));
  EXPECT_EQ(hash.hex(), vo::content_hash("\1\2\3\4\5\6\7\10"));
}

}  // namespace
