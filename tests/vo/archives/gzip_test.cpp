#include "vo/archives/gzip.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

using support::error_text;
using testing::HasSubstr;

std::string many_bytes() {
  std::string bytes;
  for (unsigned i = 0; i < 2'500'000; ++i) {
    bytes.push_back(static_cast<char>(i * i / 7));
  }
  return bytes;
}

TEST(Gzip, GivesBackWhatItPacked) {
  for (const std::string& bytes : {std::string(), std::string("a"), many_bytes()}) {
    const std::string packed = vo::gzip(bytes);
    EXPECT_TRUE(vo::is_gzip(packed));
    EXPECT_EQ(vo::gunzip(packed, bytes.size()), bytes);
  }
}

TEST(Gzip, NamesWhatIsDamagedCutOrTooLarge) {
  const std::string packed = vo::gzip(many_bytes());
  const auto error = [](const std::string& bytes, std::size_t max_bytes) {
    return error_text([&] { vo::gunzip(bytes, max_bytes); });
  };
  EXPECT_THAT(error(packed.substr(0, packed.size() / 2), 9'000'000), HasSubstr("damaged or cut"));
  EXPECT_THAT(error(packed.substr(0, 5), 9'000'000), HasSubstr("damaged or cut"));
  std::string damaged = packed;
  damaged[damaged.size() / 2] ^= 0x55;
  EXPECT_THAT(error(damaged, 9'000'000), HasSubstr("damaged or cut"));
  EXPECT_THAT(error(packed, 1'000'000), HasSubstr("holds more than 1000000 bytes"));
}

}  // namespace
