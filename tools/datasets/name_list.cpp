#include "tools/datasets/name_list.h"

#include <cstddef>
#include <sstream>

namespace tools {

std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream text(list);
  for (std::string name; std::getline(text, name, ',');) {
    const std::size_t first = name.find_first_not_of(' ');
    if (first != std::string::npos) {
      names.push_back(name.substr(first, name.find_last_not_of(' ') - first + 1));
    }
  }
  return names;
}

}  // namespace tools
