#include "tools/datasets/host_name.h"

#include <array>

#include <unistd.h>

namespace tools {

std::string host_name() {
  std::array<char, 256> name{};
  const bool is_known = ::gethostname(name.data(), name.size() - 1) == 0 && name.front() != '\0';
  return is_known ? name.data() : "host";
}

}  // namespace tools
