#pragma once

#include <filesystem>
#include <string_view>

#include "vo/files/output.h"
#include "vo/files/partial_file.h"

namespace vo {

/// A file that is written in parts, which need not be in memory together, and appears under its
/// name as one of `write_file` does. The destructor removes what was not committed.
class StreamedOutput {
 public:
  /// `extension` ends the file's name until it is committed. Throws Error, as `write_file` does,
  /// where the place cannot be written or is a device or pipe.
  StreamedOutput(const std::filesystem::path& path, const OutputPolicy& policy,
                 const std::filesystem::path& extension = {});

  void append(std::string_view bytes) { file_.append(bytes); }

  /// Empties the file and returns its path until it is committed, for one who opens files by name:
  /// what that writes is what is committed.
  std::filesystem::path open_by_name();

  /// Gives the file its name. An existing file with the same bytes is left alone; throws Error of
  /// kind output_exists for another one unless it is to be replaced.
  void commit();

 private:
  std::filesystem::path given_;
  std::filesystem::path path_;
  OutputPolicy policy_;
  PartialFile file_;
};

}  // namespace vo
