#include "tools/processes/readable_text.h"

#include <algorithm>
#include <cstddef>

namespace tools {
namespace {

bool is_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Returns a character's length by its first byte; 0 where that begins no character.
std::size_t length_from(unsigned char first) {
  if (first < 0x80U) {
    return 1;
  }
  if (first >= 0xC2U && first < 0xE0U) {
    return 2;
  }
  if (first >= 0xE0U && first < 0xF0U) {
    return 3;
  }
  return first >= 0xF0U && first < 0xF5U ? 4 : 0;
}

/// Returns whether the second byte makes neither an overlong form, a surrogate, nor a value beyond
/// Unicode's last.
bool is_allowed(unsigned char first, unsigned char second) {
  switch (first) {
    case 0xE0U:
      return second >= 0xA0U;
    case 0xEDU:
      return second < 0xA0U;
    case 0xF0U:
      return second >= 0x90U;
    case 0xF4U:
      return second < 0x90U;
    default:
      return true;
  }
}

/// Returns the length of the printable character at the start; 0 where there is none.
std::size_t readable_length(std::string_view rest) {
  const auto first = static_cast<unsigned char>(rest.front());
  const std::size_t length = length_from(first);
  if (length == 1) {
    constexpr unsigned char kDelete = 0x7F;
    return first >= ' ' && first != kDelete ? 1 : 0;
  }
  if (length == 0 || rest.size() < length) {
    return 0;
  }
  const bool continues = std::all_of(rest.begin() + 1, rest.begin() + length, is_continuation);
  return continues && is_allowed(first, static_cast<unsigned char>(rest[1])) ? length : 0;
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
