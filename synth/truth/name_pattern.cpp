#include "synth/truth/name_pattern.h"

#include <algorithm>
#include <cstddef>

#include "vo/core/utf8.h"

namespace synth {

bool matches(std::string_view pattern, std::string_view name) {
  std::string_view after_star;  // what follows the last `*` so far
  std::string_view retry;       // the name from where `after_star` is tried next
  bool has_star = false;
  while (!name.empty()) {
    if (pattern.starts_with('*')) {
      pattern.remove_prefix(1);
      has_star = true;
      after_star = pattern;
      retry = name;
    } else if (pattern.starts_with('?')) {
      pattern.remove_prefix(1);
      name.remove_prefix(std::max<std::size_t>(vo::utf8_length(name), 1));
    } else if (!pattern.empty() && pattern.front() == name.front()) {
      pattern.remove_prefix(1);
      name.remove_prefix(1);
    } else if (has_star) {
      retry.remove_prefix(1);
      pattern = after_star;
      name = retry;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*') == std::string_view::npos;
}

}  // namespace synth
