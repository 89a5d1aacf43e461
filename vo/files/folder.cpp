#include "vo/files/folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <ftw.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/files/system_failure.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

struct Closing {
  void operator()(DIR* stream) const { ::closedir(stream); }
};

EntryKind entry_kind(mode_t mode) {
  if (S_ISREG(mode)) {
    return EntryKind::file;
  }
  if (S_ISDIR(mode)) {
    return EntryKind::folder;
  }
  return S_ISLNK(mode) ? EntryKind::link : EntryKind::other;
}

[[noreturn]] void fail_to_list(const fs::path& folder) {
  fail_with(folder, "cannot be listed", errno);
}

/// Returns the next name of an open folder; nothing after the last.
std::optional<std::string> next_name(DIR* stream, const fs::path& folder) {
  errno = 0;
  const dirent* entry = ::readdir(stream);  // NOLINT(concurrency-mt-unsafe): nobody else has it
  if (entry == nullptr && errno != 0) {
    fail_to_list(folder);
  }
  return entry == nullptr ? std::nullopt : std::optional<std::string>(entry->d_name);
}

void add_below(const fs::path& root, const std::string& within, std::vector<FolderEntry>& entries) {
  for (FolderEntry& entry : entries_of(within.empty() ? root : root / within)) {
    std::string name = within.empty() ? std::move(entry.name) : within + "/" + entry.name;
    entries.push_back({name, entry.kind});
    if (entry.kind == EntryKind::folder) {
      add_below(root, name, entries);
    }
  }
}

/// Removes what nftw visits; its result ends the walk unless it is 0.
int remove_visited(const char* path, const struct stat* /*status*/, int type, FTW* /*place*/) {
  const bool is_folder = type == FTW_DP || type == FTW_D || type == FTW_DNR;
  const int result = uninterrupted([&] { return is_folder ? ::rmdir(path) : ::unlink(path); });
  return result == 0 || errno == ENOENT ? 0 : errno;
}

}  // namespace

std::vector<FolderEntry> entries_of(const fs::path& folder) {
  const std::unique_ptr<DIR, Closing> stream(::opendir(folder.c_str()));
  if (!stream) {
    fail_to_list(folder);
  }
  std::vector<FolderEntry> entries;
  while (std::optional<std::string> name = next_name(stream.get(), folder)) {
    struct stat status {};
    if (*name == "." || *name == "..") {
      continue;
    }
    if (::fstatat(::dirfd(stream.get()), name->c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) {
      entries.push_back({std::move(*name), entry_kind(status.st_mode)});
    } else if (errno != ENOENT) {  // else it has gone in between
      fail_to_list(folder);
    }
  }
  std::sort(entries.begin(), entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) { return a.name < b.name; });
  return entries;
}

std::vector<FolderEntry> entries_below(const fs::path& folder) {
  std::vector<FolderEntry> entries;
  add_below(folder, "", entries);
  return entries;
}

int remove_tree(const fs::path& path) noexcept {
  constexpr int kOpenFolders = 16;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): without FTW_CHDIR nothing is shared
  const int result = ::nftw(path.c_str(), remove_visited, kOpenFolders, FTW_DEPTH | FTW_PHYS);
  const int error = result < 0 ? errno : result;
  return error == ENOENT ? 0 : error;
}

void remove_completely(const fs::path& path) {
  if (const int error = remove_tree(path); error != 0) {
    fail_with(path, "cannot be removed", error);
  }
}

void rename_entry(const fs::path& from, const fs::path& to) {
  if (uninterrupted([&] { return ::rename(from.c_str(), to.c_str()); }) != 0) {
    fail_with(to, "cannot be written", errno);
  }
}

}  // namespace vo
