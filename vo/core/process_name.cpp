#include "vo/core/process_name.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <system_error>

#include <unistd.h>

#include "vo/core/error.h"

namespace vo {

std::string host_name() {
  std::array<char, 256> name{};
  const bool is_known = ::gethostname(name.data(), name.size() - 1) == 0 && name.front() != '\0';
  return is_known ? name.data() : "host";
}

std::string process_name() {
  return concat(host_name(), "-", ::getpid());
}

bool is_of_ended_process(std::string_view name) {
  const std::string host = host_name() + "-";
  if (!name.starts_with(host)) {
    return false;
  }
  name.remove_prefix(host.size());
  pid_t process = 0;
  const bool is_number =
      std::from_chars(name.data(), name.data() + name.size(), process).ec == std::errc();
  return is_number && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace vo
