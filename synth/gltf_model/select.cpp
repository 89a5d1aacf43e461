#include "synth/gltf_model/select.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <numeric>

#include "vo/core/error.h"

namespace synth {
namespace {

std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMostListed = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMostListed); ++i) {
    list += (i == 0 ? "" : ", ") + std::to_string(i) + " \"" + names[i] + '"';
  }
  return names.size() > kMostListed ? list + ", ..." : list;
}

}  // namespace

int select_one(const std::string& wanted, const std::vector<std::string>& names,
               const std::string& what, const std::string& place) {
  const auto named = std::find(names.begin(), names.end(), wanted);
  if (named != names.end()) {
    return static_cast<int>(named - names.begin());
  }
  std::size_t number = names.size();
  const char* end = wanted.data() + wanted.size();
  const bool is_number = std::from_chars(wanted.data(), end, number).ptr == end;
  vo::require(is_number && number < names.size(), place, ": has no ", what, " \"", wanted,
              "\", expected ", names.empty() ? "none, as it has none" : "one of " + list_of(names));
  return static_cast<int>(number);
}

std::vector<int> select_animations(const std::string& wanted, const std::vector<std::string>& names,
                                   const std::string& place) {
  if (wanted == "none") {
    return {};
  }
  if (!wanted.empty()) {
    return {select_one(wanted, names, "animation", place)};
  }
  std::vector<int> all(names.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace synth
