#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "vo/core/error.h"

/// What the fuzzers share. Each reads bytes that somebody else may have written; every reader ends
/// with a value or with vo::Error.
namespace fuzz {

/// A folder in memory, of this process alone, that holds what a reader is given.
class InputFolder {
 public:
  InputFolder() {
    std::string name = "/dev/shm/edvo-fuzz-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) {
      std::abort();
    }
    path_ = name;
  }
  ~InputFolder() { clear(); }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;
  InputFolder(InputFolder&&) = delete;
  InputFolder& operator=(InputFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path file = path_ / name;
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }

  /// Writes the files of a text `=== NAME`, bytes, `=== NAME`, bytes and so on; a name that leads
  /// out of the folder is left out.
  void write_archive(std::string_view archive) const {
    constexpr std::string_view kMark = "=== ";
    std::size_t begin = archive.find(kMark);
    while (begin != std::string_view::npos) {
      const std::size_t name_end = std::min(archive.find('\n', begin), archive.size());
      const std::string name(archive.substr(begin + kMark.size(), name_end - begin - kMark.size()));
      const std::size_t content = std::min(name_end + 1, archive.size());
      const std::size_t next = archive.find("\n=== ", content);
      if (name.find("..") == std::string::npos && name.find('\0') == std::string::npos &&
          !name.starts_with('/')) {
        write(name,
              archive.substr(content, next == std::string_view::npos ? next : next - content));
      }
      begin = next == std::string_view::npos ? next : next + 1;
    }
  }

  void clear() const {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

 private:
  std::filesystem::path path_;
};

/// Writes the input as a file and calls `read` with its path; vo::Error is a right answer.
template <typename Read>
int with_file(const std::uint8_t* data, std::size_t size, const std::string& name, Read read) {
  static const InputFolder folder;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    read(folder.write(name, bytes));
  } catch (const vo::Error&) {
    return 0;
  }
  return 0;
}

/// Writes the input's files into an empty folder and calls `read` with its path.
template <typename Read>
int with_folder(const std::uint8_t* data, std::size_t size, Read read) {
  static const InputFolder folder;
  folder.clear();
  folder.write_archive({reinterpret_cast<const char*>(data), size});
  try {
    read(folder.path());
  } catch (const vo::Error&) {
    return 0;
  }
  return 0;
}

/// Ends the program, which libFuzzer reports with its input, unless the condition holds.
inline void check(bool condition, const char* what) {
  if (!condition) {
    std::fprintf(stderr, "violated: %s\n", what);
    std::abort();
  }
}

/// Writes `text` as a file, reads it and returns the result; vo::Error is a finding here.
template <typename Read>
auto read_again(const std::string& text, const std::string& name, Read read) {
  static const InputFolder folder;
  try {
    return read(folder.write(name, text));
  } catch (const vo::Error& error) {
    check(false, error.what());
    std::abort();
  }
}

}  // namespace fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
