#include "vo/archives/zip.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace {

using support::error_text;
using testing::HasSubstr;

std::string bytes_of(const std::vector<int>& values) {
  return {values.begin(), values.end()};
}

/// By hand after PKWARE's APPNOTE.TXT; CRC-32 of "123456789" is cbf43926, the check value of that
/// code. tests/tools/written_files reads whole archives by Python's zipfile.
TEST(Zip, HoldsAFileAsTheFormatHasIt) {
  const std::string described = bytes_of(
      {20, 0, 0, 8, 0, 0, 0, 0, 33, 0, 0x26, 0x39, 0xf4, 0xcb, 9, 0, 0, 0, 9, 0, 0, 0, 1, 0, 0, 0});
  const std::string local = bytes_of({'P', 'K', 3, 4}) + described + "a123456789";
  const std::string central =
      bytes_of({'P', 'K', 1, 2, 20, 0}) + described + std::string(14, '\0') + "a";
  const std::string end = bytes_of({'P', 'K', 5, 6, 0, 0, 0, 0, 1, 0, 1, 0}) +
                          bytes_of({static_cast<int>(central.size()), 0, 0, 0}) +
                          bytes_of({static_cast<int>(local.size()), 0, 0, 0, 0, 0});
  EXPECT_EQ(vo::zip({{"a", "123456789"}}), local + central + end);
}

TEST(Zip, IsAlwaysTheSame) {
  const std::vector<vo::NamedBytes> files = {{"a/b.txt", "x"}, {"c", std::string(1000, 'y')}};
  EXPECT_EQ(vo::zip(files), vo::zip(files));
}

TEST(Zip, RefusesWhatAPlainArchiveCannotHold) {
  EXPECT_THAT(error_text([] {
                vo::zip({{std::string(70'000, 'n'), ""}});
              }),
              HasSubstr("a name of 70000 bytes"));
  const std::vector<vo::NamedBytes> many(65'535);
  EXPECT_THAT(error_text([&] { vo::zip(many); }), HasSubstr("65535 files"));
}

}  // namespace
