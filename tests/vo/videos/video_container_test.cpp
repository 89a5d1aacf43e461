#include "vo/videos/video_container.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace {

using namespace std::string_literals;
using support::TempFolder;

/// A chunk of RIFF: its name, the size of what follows, which may be stated wrongly, and that.
std::string riff(const std::string& kind, const std::string& content, std::size_t stated) {
  std::string size;
  for (int i = 0; i < 4; ++i) {
    size += static_cast<char>(stated >> (8 * i));
  }
  return "RIFF" + size + kind + content;
}

/// A box of MP4, likewise.
std::string box(const std::string& type, const std::string& content, std::size_t stated) {
  std::string size;
  for (int i = 3; i >= 0; --i) {
    size += static_cast<char>(stated >> (8 * i));
  }
  return size + type + content;
}

std::string box(const std::string& type, const std::string& content) {
  return box(type, content, content.size() + 8);
}

const std::string kEbmlHeader =
    "\x1A\x45\xDF\xA3\x84"
    "abcd";
const std::string kSegment = "\x18\x53\x80\x67";

class VideoContainerFile : public testing::Test {
 protected:
  std::optional<vo::VideoContainer> container(const std::string& bytes) const {
    return vo::video_container(folder.write("video", bytes));
  }
  bool is_cut(const std::string& bytes) const { return vo::is_cut(folder.write("video", bytes)); }

  TempFolder folder;
};

TEST_F(VideoContainerFile, IsKnownByItsFirstBytesAndNotByItsName) {
  EXPECT_EQ(container(riff("AVI ", "", 4)), vo::VideoContainer::avi);
  EXPECT_EQ(container(kEbmlHeader + kSegment), vo::VideoContainer::matroska);
  EXPECT_EQ(container(box("ftyp", "isom")), vo::VideoContainer::mp4);
  EXPECT_EQ(container(box("moov", "1234")), vo::VideoContainer::mp4);
  EXPECT_EQ(container(riff("WAVE", "", 4)), std::nullopt);
  EXPECT_EQ(container("1305031102.175304 0 0 0 0 0 0 1\n"), std::nullopt);
  EXPECT_EQ(container(""), std::nullopt);
  EXPECT_EQ(vo::video_container(folder.path()), std::nullopt);
  EXPECT_EQ(vo::video_container(folder.path() / "none"), std::nullopt);
}

TEST_F(VideoContainerFile, AnAviIsCutWhereAChunkOfRiffIsLongerThanTheFile) {
  const std::string whole = riff("AVI ", "12345678", 12);
  EXPECT_FALSE(is_cut(whole));
  EXPECT_FALSE(is_cut(whole + riff("AVIX", "1234", 8)));
  EXPECT_FALSE(is_cut(whole + "what a disk's tools leave behind it"));
  EXPECT_TRUE(is_cut(whole.substr(0, whole.size() - 2)));
  EXPECT_TRUE(is_cut(whole + riff("AVIX", "1234", 800)));
  EXPECT_TRUE(is_cut(riff("AVI ", "12345678", 0))) << "a writer that was killed";
}

TEST_F(VideoContainerFile, AnMp4IsCutWithoutItsIndexOrWithinABox) {
  const std::string head = box("ftyp", "isom");
  EXPECT_FALSE(is_cut(head + box("moov", "1234") + box("mdat", "12345678")));
  EXPECT_FALSE(is_cut(head + box("moov", "1234") + box("mdat", "12345678", 0))) << "to the end";
  EXPECT_FALSE(is_cut(head +
                      box("mdat",
                          "\0\0\0\0\0\0\0\x18"
                          "12345678"s,
                          1) +
                      box("moov", "1")))
      << "a size of 64 bits";
  EXPECT_TRUE(is_cut(head + box("mdat", "12345678")));
  EXPECT_TRUE(is_cut(head + box("moov", "1234") + box("mdat", "12345678", 800)));
  EXPECT_TRUE(is_cut(head + box("moov", "1234") + "\0\0"s));
}

TEST_F(VideoContainerFile, AMatroskaIsCutWhereItsSegmentIsLongerThanTheFile) {
  EXPECT_FALSE(is_cut(kEbmlHeader + kSegment +
                      "\x88"
                      "12345678"));
  EXPECT_FALSE(is_cut(kEbmlHeader + kSegment +
                      "\x40\x08"
                      "12345678"s))
      << "a size of two bytes";
  EXPECT_FALSE(is_cut(kEbmlHeader + kSegment +
                      "\x01\xFF\xFF\xFF\xFF\xFF\xFF\xFF"
                      "1234"))
      << "unknown, as browsers write it";
  EXPECT_TRUE(is_cut(kEbmlHeader + kSegment +
                     "\x88"
                     "1234567"));
  EXPECT_TRUE(is_cut(kEbmlHeader + kSegment));
  EXPECT_TRUE(is_cut(kEbmlHeader + "1234"));
}

}  // namespace
