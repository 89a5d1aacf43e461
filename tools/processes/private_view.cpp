#include "tools/processes/private_view.h"

#include <sched.h>
#include <sys/mount.h>

namespace tools {

void enter_view(const PrivateView& view) {
  constexpr unsigned long kReadOnly = MS_BIND | MS_REMOUNT | MS_RDONLY | MS_NOSUID | MS_NODEV;
  const bool is_private = ::unshare(CLONE_NEWNS) == 0 &&
                          ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
  if (!is_private) {
    return;
  }
  for (const std::filesystem::path& folder : view.read_only) {
    if (::mount(folder.c_str(), folder.c_str(), nullptr, MS_BIND, nullptr) == 0) {
      ::mount("none", folder.c_str(), nullptr, kReadOnly, nullptr);
    }
  }
  for (const std::filesystem::path& folder : view.hidden) {
    ::mount("none", folder.c_str(), "tmpfs", MS_RDONLY | MS_NOSUID | MS_NODEV, nullptr);
  }
}

}  // namespace tools
