#include "tools/submit/shared_work.h"

#include <algorithm>
#include <string_view>

#include "tools/processes/shell_words.h"

namespace tools {
namespace {

constexpr std::string_view kPlain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";

bool is_plain(const std::string& word, std::string_view others) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [&](char c) {
    return kPlain.find(c) != std::string_view::npos || others.find(c) != std::string_view::npos;
  });
}

}  // namespace

std::string shell_line(const std::vector<std::string>& words) {
  constexpr std::string_view kHarmless = "/=:,+@%";
  std::string line;
  for (const std::string& word : words) {
    line += (line.empty() ? "" : " ") + (is_plain(word, kHarmless) ? word : shell_quoted(word));
  }
  return line;
}

std::string job_name(const std::string& text) {
  std::string name = "edvo-";
  for (const char c : text) {
    name += is_plain(std::string(1, c), "") ? c : '_';
  }
  return name;
}

}  // namespace tools
