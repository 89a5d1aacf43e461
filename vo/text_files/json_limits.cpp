#include "vo/text_files/json_limits.h"

#include <algorithm>
#include <cstddef>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr int kDeepestNesting = 100;
constexpr std::size_t kMostValues = 20'000'000;

/// Returns the index behind the JSON string whose quote is at `begin`; one that does not end is
/// left to the parser.
std::size_t end_of_json_string(std::string_view text, std::size_t begin) {
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != '"') {
    at += text[at] == '\\' ? 2 : 1;
  }
  return std::min(at + 1, text.size());
}

}  // namespace

void require_json_within_limits(std::string_view text, const std::string& place) {
  int depth = 0;
  std::size_t values = 1;
  for (std::size_t at = 0; at < text.size(); ++at) {
    switch (text[at]) {
      case '"':
        at = end_of_json_string(text, at) - 1;
        break;
      case '[':
      case '{':
        ++depth;
        ++values;
        break;
      case ',':
        ++values;
        break;
      case ']':
      case '}':
        --depth;
        break;
      default:
        break;
    }
    require(depth <= kDeepestNesting, place, ": its JSON is nested more than ", kDeepestNesting,
            " levels deep, at byte ", at);
    require(values <= kMostValues, place, ": its JSON has more than ", kMostValues, " values");
  }
}

}  // namespace vo
