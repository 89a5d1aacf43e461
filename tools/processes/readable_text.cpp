#include "tools/processes/readable_text.h"

#include <algorithm>
#include <cstddef>

#include "vo/core/utf8.h"

namespace tools {
namespace {

/// Returns the length of the printable character at the start; 0 where there is none.
std::size_t readable_length(std::string_view rest) {
  constexpr char kDelete = 0x7F;
  const std::size_t length = vo::utf8_length(rest);
  const bool is_control = length == 1 && (rest.front() < ' ' || rest.front() == kDelete);
  return is_control ? 0 : length;
}

}  // namespace

std::string readable_text(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = readable_length(bytes);
    text += length == 0 ? "?" : bytes.substr(0, length);
    bytes.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return text;
}

}  // namespace tools
