#include "tools/datasets/part_folder.h"

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "tools/datasets/layout.h"
#include "vo/core/error.h"
#include "vo/core/process_name.h"
#include "vo/files/folder.h"
#include "vo/files/partial_file.h"
#include "vo/files/result_files.h"
#include "vo/files/system_failure.h"
#include "vo/output_folders/output_folder.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

fs::path own_partial(const fs::path& path) {
  return path.parent_path() / (PartFolder::partial_prefix(path) + vo::process_name());
}

/// Removes what killed processes of this machine left of `path`.
void remove_abandoned_folders(const fs::path& path) {
  const std::string prefix = PartFolder::partial_prefix(path);
  for (const vo::FolderEntry& entry : vo::entries_of(path.parent_path())) {
    if (entry.name.starts_with(prefix) &&
        vo::is_of_ended_process(std::string_view(entry.name).substr(prefix.size()))) {
      vo::remove_tree(path.parent_path() / entry.name);
    }
  }
}

/// Renames a folder unless one that holds something has the name; returns whether it did.
bool renamed(const fs::path& from, const fs::path& to) {
  const int result = vo::uninterrupted([&] { return ::rename(from.c_str(), to.c_str()); });
  if (result != 0 && errno != ENOTEMPTY && errno != EEXIST) {
    vo::fail_with(to, "cannot be written", errno);
  }
  return result == 0;
}

/// Returns whether it is certain that the folder of a part has no record, as one that was copied or
/// removed in part.
bool lacks_record(const fs::path& folder) {
  std::error_code error;
  return fs::symlink_status(folder / kPartRecord, error).type() == fs::file_type::not_found;
}

/// An open file, which is closed at the end of its life.
class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags)
      : path_(path), descriptor_(vo::uninterrupted([&] {
          constexpr mode_t kForAll = 0666;
          return ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, kForAll);
        })) {
    if (descriptor_ < 0) {
      vo::fail_with(path, "cannot be written", errno);
    }
  }
  ~OpenFile() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(OpenFile&&) = delete;
  OpenFile& operator=(OpenFile&&) = delete;

  /// Writes bytes and closes the file: network file systems tell of a full disk only then.
  void write(std::string_view bytes) {
    vo::write_bytes(descriptor_, bytes, path_);
    if (::close(std::exchange(descriptor_, -1)) != 0) {
      vo::fail_with(path_, "cannot be written", errno);
    }
  }

 private:
  const fs::path& path_;
  int descriptor_;
};

}  // namespace

PartFolder::PartFolder(const fs::path& path) : path_(path), partial_(own_partial(path)) {
  vo::make_folder(path.parent_path());
  remove_abandoned_folders(path);
  vo::remove_tree(partial_);
  vo::make_folder(partial_);
}

PartFolder::~PartFolder() {
  vo::remove_tree(partial_);
}

std::string PartFolder::partial_prefix(const fs::path& path) {
  return "." + path.filename().string() + ".";
}

void PartFolder::write(const std::vector<vo::NamedBytes>& files) const {
  for (const vo::NamedBytes& file : files) {
    const fs::path path = partial_ / file.name;
    vo::make_folder(path.parent_path());
    OpenFile(path, O_TRUNC).write(file.bytes);
  }
}

void PartFolder::append(const std::string& name, std::string_view bytes) const {
  const fs::path path = partial_ / name;
  vo::make_folder(path.parent_path());
  OpenFile(path, O_APPEND).write(bytes);
}

void PartFolder::commit(vo::Durability durability) {
  if (durability == vo::Durability::synced) {
    vo::sync_tree(partial_);
  }
  if (!renamed(partial_, path_) && lacks_record(path_)) {
    // It is set aside by one rename, as other tasks may put the same part there meanwhile: under
    // its name is nothing, a folder without record or a whole part, never the rest of one.
    const fs::path aside = partial_.string() + ".aside";
    vo::remove_tree(aside);
    ::rename(path_.c_str(), aside.c_str());
    vo::require(renamed(partial_, path_) || !lacks_record(path_), path_.string(), ": has no ",
                kPartRecord, " and cannot be removed");
    vo::remove_tree(aside);
  }
  if (durability == vo::Durability::synced) {
    vo::sync_to_disk(path_.parent_path());
  }
}

bool path_exists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

}  // namespace tools
