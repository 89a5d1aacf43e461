#include "vo/files/numbered_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace {

using support::TempFolder;
using testing::ElementsAre;

std::vector<std::int64_t> numbers(const std::vector<vo::NumberedFile>& files) {
  std::vector<std::int64_t> result;
  for (const vo::NumberedFile& file : files) {
    result.push_back(file.number);
  }
  return result;
}

TEST(NumberedFiles, AreInOrderOfTheirNumbersAndOfTheNamesAskedForAlone) {
  const TempFolder folder;
  for (const char* name :
       {"10.png", "9.jpg", "0008.PGM", "7.txt", "x6.png", "5", "-4.png", "3.png.part"}) {
    folder.write(std::string("a/") + name, "");
  }
  EXPECT_THAT(numbers(vo::numbered_files(folder.path(), "a", {})), ElementsAre(8, 9, 10));
  EXPECT_THAT(numbers(vo::numbered_files(folder.path(), "a", {"", "", ".txt"})), ElementsAre(7));
  EXPECT_THAT(numbers(vo::numbered_files(folder.path(), "a", {"x", "", ""})), ElementsAre(6));
  EXPECT_TRUE(vo::numbered_files(folder.path(), "b", {}).empty());
}

TEST(NumberedFiles, OneNumberTwiceIsAnError) {
  const TempFolder folder;
  folder.write("1.png", "");
  folder.write("01.png", "");
  EXPECT_THAT(support::error_text([&] { vo::numbered_files(folder.path(), "", {}); }),
              testing::HasSubstr("1.png: has the number of another file"));
}

TEST(NumberAtEnd, IsWhatANameEndsWith) {
  EXPECT_EQ(vo::number_at_end("frame_000012"), "000012");
  EXPECT_EQ(vo::number_at_end("1305031102.175304"), "1305031102.175304");
  EXPECT_EQ(vo::number_at_end("v1.2.3"), "2.3");
  EXPECT_EQ(vo::number_at_end("a.5"), "5");
  EXPECT_EQ(vo::number_at_end("cover"), "");
  EXPECT_EQ(vo::number_at_end("5."), "");
}

}  // namespace
