#include "vo/files/output.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/input.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const fs::path& path, int error) {
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  fail_as(full ? ErrorKind::temporary : ErrorKind::input, path.string(),
          ": cannot be written: ", std::generic_category().message(error));
}

[[noreturn]] void fail_to_replace(const fs::path& path) {
  fail_as(ErrorKind::output_exists, path.string(),
          ": exists and differs from the new result; use --force to replace it");
}

enum class OpenMode { truncate, create_new };

void write_bytes(const fs::path& path, std::string_view bytes, OpenMode mode) {
  const int how = mode == OpenMode::truncate ? O_CREAT | O_TRUNC : O_CREAT | O_EXCL;
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | how, 0666);
  if (file < 0) {
    fail_to_write(path, errno);
  }
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      const int error = errno;
      ::close(file);
      fail_to_write(path, error);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written > 0 ? written : 0));
  }
  if (::close(file) != 0) {
    fail_to_write(path, errno);
  }
}

constexpr const char* kPartial = "partial";

/// Returns an unused name beside `path`: `.name.partial-1234`, 1234 being this process.
fs::path unused_name(const fs::path& path, const char* purpose) {
  for (int attempt = 0;; ++attempt) {
    fs::path name =
        path.parent_path() / concat(".", path.filename().string(), ".", purpose, "-", ::getpid(),
                                    attempt == 0 ? "" : "-" + std::to_string(attempt));
    if (!fs::exists(fs::symlink_status(name))) {
      return name;
    }
  }
}

/// Returns the absolute path without dots, links or a slash at its end.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  fs::path place = fs::weakly_canonical(fs::absolute(path), error);
  if (error) {
    fail_to_write(path, error.value());
  }
  return place.has_filename() ? place : place.parent_path();
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path().lexically_relative(folder));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool have_same_files(const fs::path& a, const fs::path& b) {
  const std::vector<fs::path> files = files_below(a);
  return files == files_below(b) &&
         std::all_of(files.begin(), files.end(), [&](const fs::path& file) {
           return read_file(a / file) == read_file(b / file);
         });
}

/// Renames a folder to `path`, replacing and removing a folder that is there.
void put_in_place(const fs::path& made, const fs::path& path) {
  const fs::path old = unused_name(path, "old");
  std::error_code error;
  if (fs::exists(path)) {
    fs::rename(path, old, error);
  }
  if (!error) {
    fs::rename(made, path, error);
    if (error && fs::exists(old)) {
      std::error_code ignored;
      fs::rename(old, path, ignored);
    }
  }
  if (error) {
    fail_to_write(path, error.value());
  }
  remove_quietly(old);
}

/// Throws Error if the current folder is `path` or lies in it, because `path` is to be replaced.
void require_elsewhere(const fs::path& path) {
  const std::string here = fs::current_path().string() + "/";
  require(!here.starts_with(path.string() + "/") || !fs::exists(path) || fs::is_empty(path),
          path.string(), ": is the current folder or one above it, expected another to write");
}

/// Removes files that `write_file` was writing when its process was killed.
void remove_unfinished(const fs::path& folder) {
  for (const fs::path& file : files_below(folder)) {
    const std::string name = file.filename().string();
    if (name.starts_with('.') && name.find(concat(".", kPartial, "-")) != std::string::npos) {
      remove_quietly(folder / file);
    }
  }
}

/// Makes a folder that holds its marker from the start. Does nothing where another process was
/// first.
void begin(const fs::path& folder, const NamedBytes& marker) {
  const fs::path fresh = unused_name(folder, kPartial);
  std::error_code error;
  fs::create_directories(fresh, error);
  if (error) {
    fail_to_write(folder, error.value());
  }
  try {
    write_bytes(fresh / marker.name, marker.bytes, OpenMode::create_new);
  } catch (const Error& failure) {
    remove_quietly(fresh);
    throw;
  }
  fs::rename(fresh, folder, error);
  if (error) {
    remove_quietly(fresh);
  }
}

}  // namespace

bool is_stream(const fs::path& path) {
  const std::string place = fs::absolute(path).lexically_normal().string();
  return place.starts_with("/dev/") || place.starts_with("/proc/") ||
         (fs::exists(path) && !fs::is_regular_file(path) && !fs::is_directory(path));
}

void require_no_conflict(const fs::path& path, std::string_view bytes, ExistingOutput existing) {
  if (existing == ExistingOutput::keep && fs::is_regular_file(path) && read_file(path) != bytes) {
    fail_to_replace(path);
  }
}

void write_file(const fs::path& given, std::string_view bytes, ExistingOutput existing) {
  if (is_stream(given)) {
    write_bytes(given, bytes, OpenMode::truncate);
    return;
  }
  const fs::path path = resolved(given);
  if (fs::is_regular_file(path)) {
    if (read_file(path) == bytes) {
      return;
    }
    require_no_conflict(given, bytes, existing);
  }
  const fs::path partial = unused_name(path, kPartial);
  try {
    write_bytes(partial, bytes, OpenMode::create_new);
  } catch (const Error& error) {
    remove_quietly(partial);
    throw;
  }
  std::error_code error;
  fs::rename(partial, path, error);
  if (error) {
    remove_quietly(partial);
    fail_to_write(given, error.value());
  }
}

void write_files(const fs::path& folder, const std::vector<NamedBytes>& files,
                 ExistingOutput existing) {
  for (const auto& [name, bytes] : files) {
    const fs::path parent = (folder / name).parent_path();
    std::error_code error;
    fs::create_directories(parent, error);
    if (error) {
      fail_to_write(parent, error.value());
    }
    write_file(folder / name, bytes, existing);
  }
}

void require_writable(const fs::path& path) {
  require(!fs::is_directory(path), path.string(), ": is a folder, expected a file to write");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  require(fs::is_directory(folder), path.string(), ": cannot be written: there is no folder ",
          folder.string());
  if (::access(is_stream(path) ? path.c_str() : folder.c_str(), W_OK) != 0) {
    fail_to_write(path, errno);
  }
}

void require_replaceable(const fs::path& path, const std::string& marker, ExistingOutput existing) {
  if (!fs::exists(path)) {
    return;
  }
  require(fs::is_directory(path), path.string(), ": is a file, expected a folder to write");
  if (fs::is_empty(path)) {
    return;
  }
  if (existing == ExistingOutput::keep) {
    fail_to_replace(path);
  }
  require(fs::exists(path / marker), path.string(), ": holds other files than edvo's (no ", marker,
          "), so it is not replaced");
}

OutputFolder::OutputFolder(const fs::path& path, std::string marker, ExistingOutput existing)
    : path_(resolved(path)), marker_(std::move(marker)), existing_(existing) {
  require_elsewhere(path_);
  std::error_code error;
  fs::create_directories(path_.parent_path(), error);
  if (!error) {
    partial_ = unused_name(path_, kPartial);
    fs::create_directory(partial_, error);
  }
  if (error) {
    fail_to_write(path, error.value());
  }
}

OutputFolder::~OutputFolder() {
  remove_quietly(partial_);
}

void OutputFolder::commit() {
  if (fs::is_directory(path_) && have_same_files(path_, partial_)) {
    return;
  }
  require_replaceable(path_, marker_, existing_);
  put_in_place(partial_, path_);
}

StagedFolder::StagedFolder(const fs::path& path, const NamedBytes& marker, ExistingOutput existing)
    : path_(resolved(path)),
      staging_(staging_of(path)),
      marker_name_(marker.name),
      existing_(existing) {
  require_elsewhere(path_);
  const auto is_joined = [&] {
    const fs::path file = staging_ / marker.name;
    return fs::is_regular_file(file) && read_file(file) == marker.bytes;
  };
  if (fs::exists(staging_) && !is_joined()) {
    require_replaceable(staging_, marker_name_, existing);
    remove_quietly(staging_);
  }
  if (!fs::exists(staging_)) {
    begin(staging_, marker);
    require(is_joined(), staging_.string(), ": another run makes it for another result");
  }
}

fs::path StagedFolder::staging_of(const fs::path& path) {
  return resolved(path).string() + ".part";
}

void StagedFolder::commit() {
  require_replaceable(path_, marker_name_, existing_);
  remove_unfinished(staging_);
  put_in_place(staging_, path_);
}

}  // namespace vo
