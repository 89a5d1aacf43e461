#include "tools/submit/shares.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <set>

#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::size_t kMostTasks = 1000;          // of one array
constexpr std::size_t kMostShares = 100'000'000;  // of a text that names ranges

std::size_t parse_share(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  vo::require(error == std::errc() && end == text.data() + text.size(), "\"", text,
              "\" is no number of a share, expected such as 1,3-5");
  return number;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

std::vector<std::size_t> parse_shares(std::string_view text) {
  std::set<std::size_t> shares;
  for (std::string_view rest = without_blanks(text); !rest.empty();) {
    const std::string_view range = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), range.size() + 1));
    const std::size_t dash = range.find('-');
    const std::size_t first = parse_share(range.substr(0, dash));
    const std::size_t last =
        dash == std::string_view::npos ? first : parse_share(range.substr(dash + 1));
    vo::require(first <= last && last - first < kMostShares, "\"", range,
                "\" is no range of shares, expected such as 3-5");
    for (std::size_t share = first; share <= last; ++share) {
      shares.insert(shares.end(), share);
    }
  }
  return {shares.begin(), shares.end()};
}

std::vector<std::size_t> all_shares(std::size_t count) {
  std::vector<std::size_t> shares(count);
  std::iota(shares.begin(), shares.end(), std::size_t{1});
  return shares;
}

std::vector<std::size_t> ArrayChunk::shares() const {
  std::vector<std::size_t> numbers = indices;
  for (std::size_t& number : numbers) {
    number += offset;
  }
  return numbers;
}

std::vector<ArrayChunk> chunk_shares(const std::vector<std::size_t>& shares,
                                     std::size_t max_array_size) {
  vo::require(max_array_size > 1, "MaxArraySize is ", max_array_size,
              ": expected at least 2, so that an array has a task");
  const std::size_t size = std::min(kMostTasks, max_array_size - 1);
  std::vector<ArrayChunk> chunks;
  for (const std::size_t share : shares) {
    const std::size_t offset = (share - 1) / size * size;
    if (chunks.empty() || chunks.back().offset != offset) {
      chunks.push_back({.offset = offset, .indices = {}});
    }
    chunks.back().indices.push_back(share - offset);
  }
  return chunks;
}

}  // namespace tools
