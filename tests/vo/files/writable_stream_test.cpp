#include "vo/files/writable_stream.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"
#include "vo/files/output.h"
#include "vo/files/partial_file.h"

namespace {

using support::error_kind;
using support::TempFolder;
using vo::ErrorKind;

/// More than a pipe holds: 64 KiB as Linux makes it, at most 1 MiB where an administrator says so.
constexpr std::size_t kMoreThanAPipe = 3 << 20;

std::filesystem::path make_fifo(const TempFolder& folder) {
  std::filesystem::path path = folder.path() / "pipe";
  if (::mkfifo(path.c_str(), 0600) != 0) {
    vo::fail("no pipe could be made");
  }
  return path;
}

/// Reads a descriptor to its end and closes it.
std::string read_all(int descriptor) {
  std::string bytes;
  std::array<char, 5000> part;
  for (ssize_t count = 1; count > 0;) {
    count = ::read(descriptor, part.data(), part.size());
    bytes.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  ::close(descriptor);
  return bytes;
}

void give_up() {
  vo::fail_as(ErrorKind::interrupted, "enough");
}

const vo::OutputPolicy kImpatient{vo::ExistingOutput::keep, vo::Durability::unsynced, give_up};

TEST(WritableStream, WaitsForThePipesReaderAndForItsRoom) {
  const TempFolder folder;
  const std::filesystem::path path = make_fifo(folder);
  std::string bytes(kMoreThanAPipe, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<char>(i * 7 + i / 4096);
  }
  std::string received;
  std::unique_ptr<std::thread> reader;
  vo::WritableStream stream(path, [&] {
    if (!reader) {  // comes only once the writer waits
      reader = std::make_unique<std::thread>(
          [&] { received = read_all(::open(path.c_str(), O_RDONLY)); });
    }
  });
  stream.append(bytes.substr(0, 10));
  stream.append(bytes.substr(10));
  stream.close();
  ASSERT_NE(reader, nullptr);
  reader->join();
  EXPECT_EQ(received, bytes);
}

TEST(WriteFile, GivesUpAPipeWithoutAReaderWhenItsObserverThrows) {
  const TempFolder folder;
  const std::filesystem::path path = make_fifo(folder);
  EXPECT_EQ(error_kind([&] { vo::write_file(path, "x", kImpatient); }), ErrorKind::interrupted);
}

TEST(WriteFile, GivesUpAFullPipeWhenItsObserverThrows) {
  const TempFolder folder;
  const std::filesystem::path path = make_fifo(folder);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  const std::string bytes(kMoreThanAPipe, 'x');
  EXPECT_EQ(error_kind([&] { vo::write_file(path, bytes, kImpatient); }), ErrorKind::interrupted);
  const std::string held = read_all(reader);
  EXPECT_FALSE(held.empty());
  EXPECT_EQ(held, bytes.substr(0, held.size()));
}

TEST(WriteFile, GivesUpAFileThatAnotherWritesWhenItsObserverThrows) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "a";
  const vo::PartialFile other(path);
  EXPECT_EQ(error_kind([&] { vo::write_file(path, "x", kImpatient); }), ErrorKind::interrupted);
}

}  // namespace
