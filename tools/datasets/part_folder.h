#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "vo/files/output.h"

namespace tools {

/// A folder that one task fills and that appears under its name by one rename when it is complete,
/// without a lock, so that tasks of several machines may make it at once on a network file system:
/// the first one that is complete stays, and the others' are removed. Until then it is
/// `.NAME.HOST-PID` beside its name.
class PartFolder {
 public:
  /// Begins the folder; removes what killed processes of this machine left of it. Throws vo::Error
  /// where it cannot be made.
  explicit PartFolder(const std::filesystem::path& path);
  ~PartFolder();
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;
  PartFolder(PartFolder&&) = delete;
  PartFolder& operator=(PartFolder&&) = delete;

  /// Returns the beginning of the names that processes give a folder until it is complete.
  static std::string partial_prefix(const std::filesystem::path& path);

  const std::filesystem::path& partial() const { return partial_; }  ///< folder to write into

  /// Writes files and the folders that hold them, from any thread.
  void write(const std::vector<vo::NamedBytes>& files) const;

  /// Writes bytes behind those that a file has, from one thread at a time.
  void append(const std::string& name, std::string_view bytes) const;

  /// Gives the folder its name unless a part is there; a folder there without a record is removed.
  /// Throws vo::Error where it cannot be.
  void commit(vo::Durability durability);

 private:
  std::filesystem::path path_;
  std::filesystem::path partial_;
};

/// Returns whether something is at a path; false where that cannot be known.
bool path_exists(const std::filesystem::path& path);

}  // namespace tools
