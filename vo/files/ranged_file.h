#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace vo {

/// A regular file that is open for reading at any place, by any number of threads at once.
class RangedFile {
 public:
  /// Opens without waiting, which a pipe without a writer would have one do. Throws Error naming
  /// the path: `input` if it is no regular file or cannot be read.
  explicit RangedFile(std::filesystem::path path);

  ~RangedFile();
  RangedFile(const RangedFile&) = delete;
  RangedFile& operator=(const RangedFile&) = delete;
  RangedFile(RangedFile&&) = delete;
  RangedFile& operator=(RangedFile&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uintmax_t size() const { return size_; }  ///< bytes, when the file was opened

  /// Returns `count` bytes from `offset` on, fewer where the file ends before. Throws Error naming
  /// the path: `temporary` if there is not enough memory for them. Memory is asked for within the
  /// file's size alone.
  std::string read(std::uintmax_t offset, std::uintmax_t count) const;

 private:
  std::filesystem::path path_;
  int descriptor_;
  std::uintmax_t size_ = 0;
};

}  // namespace vo
