#include "vo/files/output.h"

#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/files/system_failure.h"
#include "vo/files/writable_stream.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

void write_stream(const fs::path& path, std::string_view bytes, const OutputPolicy& policy) {
  WritableStream stream(path, policy.waiting);
  stream.append(bytes);
  stream.close();
}

/// Returns where a chain of symbolic links leads whose last target is not there yet.
fs::path link_target(fs::path path) {
  constexpr int kLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int link = 0;
       link < kLinks && fs::is_symlink(fs::symlink_status(path, error)) && !fs::exists(path, error);
       ++link) {
    const fs::path target = fs::read_symlink(path, error);
    if (error) {
      break;
    }
    path = path.parent_path() / target;
  }
  return path;
}

}  // namespace

bool is_stream(const fs::path& path) {
  const std::string place = fs::absolute(path).lexically_normal().string();
  if (place == kStdoutPath || place == "/dev/stderr" || place.starts_with("/dev/fd/") ||
      place.starts_with("/proc/")) {
    return true;  // even where the descriptor is that of a file
  }
  const fs::file_status status = fs::status(path);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void require_no_conflict(const fs::path& path, std::string_view bytes, ExistingOutput existing) {
  if (existing == ExistingOutput::keep && fs::is_regular_file(path) && read_file(path) != bytes) {
    fail_to_replace(path);
  }
}

void write_file(const fs::path& given, std::string_view bytes, const OutputPolicy& policy) {
  if (is_stream(given)) {
    write_stream(given, bytes, policy);
    return;
  }
  const fs::path path = resolved_output(given);
  if (fs::is_regular_file(path)) {
    if (read_file(path) == bytes) {
      remove_abandoned(path);
      return;
    }
    require_no_conflict(given, bytes, policy.existing);
  }
  PartialFile(path, {}, policy.waiting).commit(bytes, policy.durability);
}

void write_files(const fs::path& folder, const std::vector<NamedBytes>& files,
                 const OutputPolicy& policy) {
  for (const auto& [name, bytes] : files) {
    const fs::path parent = (folder / name).parent_path();
    std::error_code error;
    fs::create_directories(parent, error);
    if (error) {
      fail_with(parent, "cannot be made", error.value());
    }
    write_file(folder / name, bytes, policy);
  }
}

void require_writable(const fs::path& path) {
  require(!fs::is_directory(path), path.string(), ": is a folder, expected a file to write");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  require(fs::is_directory(folder), path.string(), ": cannot be written: there is no folder ",
          folder.string());
  if (path == kStdoutPath && (::fcntl(STDOUT_FILENO, F_GETFL) & O_ACCMODE) == O_RDONLY) {
    fail_with(path, "cannot be written", EBADF);
  }
  if (::access(is_stream(path) ? path.c_str() : folder.c_str(), W_OK) != 0) {
    fail_with(path, "cannot be written", errno);
  }
}

fs::path resolved_output(const fs::path& path) {
  std::error_code error;
  fs::path place = fs::weakly_canonical(link_target(fs::absolute(path)), error);
  if (error) {
    fail_with(path, "cannot be written", error.value());
  }
  return place.has_filename() ? place : place.parent_path();
}

void fail_to_replace(const fs::path& path) {
  fail_as(ErrorKind::output_exists, path.string(),
          ": exists and differs from the new result; use --force to replace it");
}

}  // namespace vo
