#include "tools/manual/command_outline.h"

#include <algorithm>

namespace tools {

std::string summary(const std::string& description) {
  const std::size_t end =
      std::min({description.find(". "), description.find(".\n"), description.find("\n\n")});
  std::string text = description.substr(0, end);
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (!text.empty() && text.back() == '.') {
    text.pop_back();
  }
  return text;
}

}  // namespace tools
