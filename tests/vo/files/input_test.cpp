#include "vo/files/input.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

TEST(ReadFile, ReturnsEveryByte) {
  const TempFolder folder;
  std::string bytes;
  for (int i = 0; i < 200'000; ++i) {
    bytes.push_back(static_cast<char>(i * 7));
  }
  folder.write("bytes", bytes);
  EXPECT_EQ(vo::read_file(folder.path() / "bytes"), bytes);
  folder.write("none", "");
  EXPECT_EQ(vo::read_file(folder.path() / "none"), "");
}

TEST(ReadFile, NamesWhatIsNoRegularFileAndNeverWaitsForIt) {
  const TempFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto error = [](const std::filesystem::path& path) {
    return error_text([&] { vo::read_file(path); });
  };
  EXPECT_THAT(error(pipe), HasSubstr("pipe: is a pipe, expected a regular file"));
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{.sun_family = AF_UNIX};
  (folder.path() / "socket").string().copy(address.sun_path, sizeof(address.sun_path) - 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_THAT(error(folder.path() / "socket"),
              HasSubstr("socket: is a socket, expected a regular file"));
  ::close(socket);
  EXPECT_EQ(error("/dev/zero"), "/dev/zero: is a device, expected a regular file");
  EXPECT_THAT(error(folder.path()), HasSubstr(": is a folder, expected a regular file"));
  EXPECT_THAT(error(folder.path() / "none"), HasSubstr("none: there is no such file"));
}

TEST(ReadFile, ReadsNothingThatIsTooLarge) {
  const TempFolder folder;
  folder.write("sparse", "");
  std::filesystem::resize_file(folder.path() / "sparse", 5'000'000'000);
  EXPECT_THAT(error_text([&] { vo::read_file(folder.path() / "sparse"); }),
              HasSubstr("has 5000000000 bytes, expected at most 4000000000"));
  EXPECT_THAT(error_text([&] { vo::read_file(folder.path() / "sparse", 10); }),
              HasSubstr("expected at most 10"));
}

TEST(PathIn, FollowsNoSymbolicLinkOutOfTheFolder) {
  const TempFolder folder;
  folder.write("outside/1.png", "");
  folder.write("seq/rgb/1.png", "");
  const std::filesystem::path seq = folder.path() / "seq";
  std::filesystem::create_symlink("rgb/1.png", seq / "inner.png");
  std::filesystem::create_symlink("../outside/1.png", seq / "outer.png");
  std::filesystem::create_directory_symlink("../outside", seq / "depth");
  std::filesystem::create_directory_symlink("rgb", seq / "colour");
  std::filesystem::create_symlink("../../outside/1.png", seq / "rgb/outer.png");
  std::filesystem::create_directory_symlink("seq", folder.path() / "alias");
  EXPECT_EQ(vo::path_in(seq, "inner.png", "rgb.txt:1"), seq / "inner.png");
  EXPECT_EQ(vo::path_in(seq, "colour/1.png", "rgb.txt:1"), seq / "colour/1.png");
  EXPECT_EQ(vo::path_in(folder.path() / "alias", "rgb/1.png", "rgb.txt:1"),
            folder.path() / "alias/rgb/1.png");
  for (const char* name : {"outer.png", "depth/1.png", "depth/none.png", "colour/outer.png"}) {
    EXPECT_THAT(
        error_text([&] { vo::path_in(seq, name, "rgb.txt:7"); }),
        HasSubstr("rgb.txt:7: '" + std::string(name) + "' leads by a symbolic link out of"));
  }
}

TEST(PathIn, StaysInTheFolder) {
  EXPECT_EQ(vo::path_in("seq", "rgb/./1.png", "rgb.txt:1"), "seq/rgb/1.png");
  EXPECT_EQ(vo::path_in("seq", "rgb/../depth/1.png", "rgb.txt:1"), "seq/depth/1.png");
  for (const char* name : {"../1.png", "/etc/passwd", "rgb/../../1.png", ".."}) {
    EXPECT_THAT(error_text([&] { vo::path_in("seq", name, "rgb.txt:7"); }),
                HasSubstr("rgb.txt:7: '" + std::string(name) + "' leads out of seq"));
  }
}

TEST(CopyStream, CopiesAPipeToItsEndAndNoMoreThanItsLimit) {
  const TempFolder folder;
  const std::filesystem::path kept = folder.write("kept", "");
  const auto copy = [&](std::uintmax_t max_bytes, const vo::WaitObserver& waiting) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    ASSERT_EQ(::write(pipe[1], "12345", 5), 5);
    ::close(pipe[1]);
    const int to = ::open(kept.c_str(), O_WRONLY | O_TRUNC);
    const auto close_both = [&](const int* /*unused*/) {
      ::close(pipe[0]);
      ::close(to);
    };
    const std::unique_ptr<const int, decltype(close_both)> closing(&to, close_both);
    vo::copy_stream(pipe[0], to, "stream", max_bytes, waiting);
  };
  copy(5, [] {});
  EXPECT_EQ(vo::read_file(kept), "12345");
  EXPECT_EQ(error_text([&] { copy(4, [] {}); }),
            "stream: gives more than 4 bytes, expected at most those");
  EXPECT_EQ(error_text([&] { copy(5, [] { vo::fail("stopped"); }); }), "stopped");
}

}  // namespace
