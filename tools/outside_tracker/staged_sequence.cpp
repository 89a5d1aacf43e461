#include "tools/outside_tracker/staged_sequence.h"

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "vo/files/folder.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// A file descriptor, closed by the destructor.
class OpenFile {
 public:
  OpenFile(const fs::path& file, int flags) : descriptor_(::open(file.c_str(), flags, 0600)) {}
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(OpenFile&&) = delete;
  OpenFile& operator=(OpenFile&&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Makes a file that shares the blocks of another; returns whether the file system can.
bool clone_file(const fs::path& from, const fs::path& to) {
  const OpenFile source(from, O_RDONLY | O_CLOEXEC);
  const OpenFile target(to, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
  return ::ioctl(target.descriptor(), FICLONE, source.descriptor()) == 0;
}

[[noreturn]] void fail_to_stage(const fs::path& file, const std::error_code& error) {
  vo::fail_with(file, "cannot be copied for the tracker", error.value());
}

void copy_read_only(const fs::path& from, const fs::path& to) {
  std::error_code error;
  if (!clone_file(from, to)) {
    fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  }
  if (!error) {
    fs::permissions(to, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read,
                    error);
  }
  if (error) {
    fail_to_stage(from, error);
  }
}

/// Takes the permission to write from the folder and those directly in it.
void make_read_only(const fs::path& folder) {
  constexpr auto kWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  for (const vo::FolderEntry& entry : vo::entries_of(folder)) {
    if (entry.kind == vo::EntryKind::folder) {
      fs::permissions(folder / entry.name, kWrite, fs::perm_options::remove);
    }
  }
  fs::permissions(folder, kWrite, fs::perm_options::remove);
}

/// Copies the regular files that lie directly in a folder.
void copy_folder(const fs::path& from, const fs::path& to, const vo::WaitObserver& waiting) {
  std::error_code error;
  fs::create_directories(to, error);
  if (error) {
    fail_to_stage(to, error);
  }
  for (const vo::FolderEntry& entry : vo::entries_of(from)) {
    if (entry.kind == vo::EntryKind::file) {
      copy_read_only(from / entry.name, to / entry.name);
      waiting();
    }
  }
}

}  // namespace

void stage_sequence(const fs::path& sequence, vo::SequenceContent content, const fs::path& folder,
                    const vo::WaitObserver& waiting) {
  std::vector<std::string> files{"rgb.txt", "camera.toml", "imu.csv", "imu.toml"};
  copy_folder(sequence / "rgb", folder / "rgb", waiting);
  if (content == vo::SequenceContent::colour_and_depth) {
    files.insert(files.end(), {"depth.txt", "associations.txt"});
    copy_folder(sequence / "depth", folder / "depth", waiting);
  }
  for (const std::string& file : files) {
    if (fs::is_regular_file(sequence / file)) {
      copy_read_only(sequence / file, folder / file);
    }
  }
  make_read_only(folder);
}

}  // namespace tools
