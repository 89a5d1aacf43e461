#include "vo/core/utf8.h"

#include <algorithm>

namespace vo {
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

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = length_from(first);
  if (length <= 1) {
    return length;
  }
  if (text.size() < length) {
    return 0;
  }
  const std::string_view following = text.substr(1, length - 1);
  const bool continues = std::all_of(following.begin(), following.end(), is_continuation);
  return continues && is_allowed(first, static_cast<unsigned char>(following.front())) ? length : 0;
}

}  // namespace vo
