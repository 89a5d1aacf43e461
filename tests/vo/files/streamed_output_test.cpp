#include "vo/files/streamed_output.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/archives/crc32.h"
#include "vo/files/input.h"
#include "vo/files/ranged_file.h"

namespace {

namespace fs = std::filesystem;
using support::error_kind;
using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

void write_parts(const fs::path& path, const vo::OutputPolicy& policy = {}) {
  vo::StreamedOutput output(path, policy);
  output.append("one ");
  output.append("two");
  output.commit();
}

TEST(StreamedOutput, AppearsWhenItIsComplete) {
  const TempFolder folder;
  const fs::path path = folder.path() / "a";
  {
    vo::StreamedOutput output(path, {});
    output.append("one ");
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_TRUE(fs::is_empty(folder.path())) << "what was not committed is gone";
  write_parts(path);
  EXPECT_EQ(vo::read_file(path), "one two");
}

TEST(StreamedOutput, OneWithAnExtensionTakesOverWhatAKilledWriterLeft) {
  const TempFolder folder;
  const fs::path left = folder.write(".a.avi.partial-edvo.avi", "longer than what is written now");
  {
    vo::StreamedOutput output(folder.path() / "a.avi", {}, ".avi");
    EXPECT_EQ(output.open_by_name(), left);
    EXPECT_EQ(vo::read_file(left), "");
    output.append("new");
    output.commit();
  }
  EXPECT_EQ(vo::read_file(folder.path() / "a.avi"), "new");
  EXPECT_FALSE(fs::exists(left));
}

TEST(StreamedOutput, ReplacesAnotherFileOnlyIfToldSo) {
  const TempFolder folder;
  const fs::path path = folder.write("a", "other");
  EXPECT_EQ(error_kind([&] { write_parts(path); }), vo::ErrorKind::output_exists);
  EXPECT_EQ(vo::read_file(path), "other");
  write_parts(path, vo::ExistingOutput::replace);
  EXPECT_EQ(vo::read_file(path), "one two");
  write_parts(path);
  EXPECT_EQ(vo::read_file(path), "one two") << "the same bytes are no conflict";
  EXPECT_THAT(error_text([&] { write_parts("/dev/null"); }), HasSubstr("is a device or pipe"));
}

TEST(RangedFile, ReadsWhatIsThere) {
  const TempFolder folder;
  const vo::RangedFile file(folder.write("a", "0123456789"));
  EXPECT_EQ(file.size(), 10U);
  EXPECT_EQ(file.read(3, 4), "3456");
  EXPECT_EQ(file.read(8, std::uintmax_t{1} << 62), "89") << "no more memory than the file has";
  EXPECT_EQ(file.read(11, 4), "");
  EXPECT_THAT(error_text([&] { vo::RangedFile(folder.path()); }), HasSubstr("is a folder"));
  EXPECT_THAT(error_text([&] { vo::RangedFile(folder.path() / "b"); }),
              HasSubstr("there is no such file"));
}

// The check value of CRC-32 that its catalogues have.
TEST(Crc32, IsThatOfItsCheckValue) {
  EXPECT_EQ(vo::crc32_of("123456789"), 0xCBF43926U);
  EXPECT_EQ(vo::crc32_of("6789", vo::crc32_of("12345")), 0xCBF43926U);
}

}  // namespace
