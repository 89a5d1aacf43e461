#include "vo/archives/tar.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

using support::error_text;
using testing::HasSubstr;

/// By hand after POSIX's table of ustar headers; the checksum is the sum of the header's bytes with
/// blanks in its place. tests/tools/datasets reads whole archives by Python's tarfile and by tar.
TEST(Tar, HoldsAFileAsTheFormatHasIt) {
  const std::string entry = vo::tar_entry({"a/b.txt", "hello"});
  ASSERT_EQ(entry.size(), 1024U);
  EXPECT_EQ(entry.substr(0, 8), std::string("a/b.txt\0", 8));
  EXPECT_EQ(entry.substr(100, 8), std::string("0000644\0", 8));
  EXPECT_EQ(entry.substr(124, 12), std::string("00000000005\0", 12));
  EXPECT_EQ(entry.substr(136, 12), std::string("00000000000\0", 12));
  EXPECT_EQ(entry[156], '0');
  EXPECT_EQ(entry.substr(257, 8), std::string("ustar\00000", 8));
  EXPECT_EQ(entry.substr(512, 6), std::string("hello\0", 6));

  std::string header = entry.substr(0, 512);
  const int stated = std::stoi(header.substr(148, 6), nullptr, 8);
  std::fill_n(header.begin() + 148, 8, ' ');
  int sum = 0;
  for (const char c : header) {
    sum += static_cast<unsigned char>(c);
  }
  EXPECT_EQ(stated, sum);
}

TEST(Tar, FillsBlocks) {
  EXPECT_EQ(vo::tar_entry({"empty", ""}).size(), 512U);
  EXPECT_EQ(vo::tar_entry({"full", std::string(512, 'x')}).size(), 1024U);
  EXPECT_EQ(vo::tar_entry({"more", std::string(513, 'x')}).size(), 1536U);
  EXPECT_EQ(vo::tar_end(), std::string(1024, '\0'));
}

TEST(Tar, RefusesNamesThatItCannotHold) {
  EXPECT_EQ(vo::tar_entry({std::string(100, 'n'), ""}).substr(0, 100), std::string(100, 'n'));
  EXPECT_THAT(error_text([] {
                vo::tar_entry({std::string(101, 'n'), ""});
              }),
              HasSubstr("expected a name of 1 to 100 bytes"));
}

}  // namespace
