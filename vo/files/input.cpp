#include "vo/files/input.h"

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <poll.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/partial_file.h"
#include "vo/files/ranged_file.h"
#include "vo/files/system_failure.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

bool is_within(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

std::string read_file(const fs::path& path, std::uintmax_t max_bytes) {
  const RangedFile file(path);
  require(file.size() <= max_bytes, path.string(), ": has ", file.size(),
          " bytes, expected at most ", max_bytes);
  return file.read(0, file.size());
}

void copy_stream(int from, int to, const std::string& name, std::uintmax_t max_bytes,
                 const WaitObserver& waiting) {
  constexpr std::size_t kPartBytes = 1 << 20;
  constexpr int kWaitMs = 100;
  std::string part(kPartBytes, '\0');
  std::uintmax_t size = 0;
  for (;;) {
    waiting();
    pollfd ready{.fd = from, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, kWaitMs) <= 0) {
      continue;
    }
    const ssize_t count = ::read(from, part.data(), part.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) {
      continue;
    }
    if (count < 0) {
      fail_with(name, "cannot be read", errno);
    }
    if (count == 0) {
      return;
    }
    size += static_cast<std::uintmax_t>(count);
    require(size <= max_bytes, name, ": gives more than ", max_bytes,
            " bytes, expected at most those");
    write_bytes(to, std::string_view(part).substr(0, static_cast<std::size_t>(count)), name);
  }
}

bool leads_out(const fs::path& folder, const fs::path& relative) {
  fs::path path = folder;
  std::error_code error;
  for (const fs::path& part : relative) {
    path /= part;
    if (fs::symlink_status(path, error).type() == fs::file_type::symlink) {
      const fs::path home = fs::canonical(folder.empty() ? "." : folder, error);
      const fs::path target = fs::weakly_canonical(folder / relative, error);
      return !is_within(home, target);
    }
  }
  return false;
}

fs::path path_in(const fs::path& folder, const std::string& name, const std::string& place) {
  const fs::path relative = fs::path(name).lexically_normal();
  require(!relative.is_absolute() && *relative.begin() != "..", place, ": '", name,
          "' leads out of ", folder.string(), ", expected a file in it");
  require(!leads_out(folder, relative), place, ": '", name, "' leads by a symbolic link out of ",
          folder.string(), ", expected a file in it");
  return folder / relative;
}

}  // namespace vo
