#include "vo/geometry/associate.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vo {
namespace {

struct Candidate {
  double difference;
  std::size_t a;
  std::size_t b;
};

/// Returns all pairs closer than the limit, in increasing order of a, then b.
std::vector<Candidate> candidates(std::span<const double> a, std::span<const double> b,
                                  double max_difference) {
  std::vector<Candidate> result;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    while (begin < b.size() && a[i] - b[begin] >= max_difference) {
      ++begin;
    }
    for (std::size_t j = begin; j < b.size() && b[j] - a[i] < max_difference; ++j) {
      result.push_back({std::abs(a[i] - b[j]), i, j});
    }
  }
  return result;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> associate(std::span<const double> a,
                                                           std::span<const double> b,
                                                           double max_difference) {
  std::vector<Candidate> closest_first = candidates(a, b, max_difference);
  std::sort(closest_first.begin(), closest_first.end(), [](const auto& x, const auto& y) {
    return std::tie(x.difference, x.a, x.b) < std::tie(y.difference, y.a, y.b);
  });
  std::vector<bool> a_is_used(a.size());
  std::vector<bool> b_is_used(b.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const Candidate& candidate : closest_first) {
    if (!a_is_used[candidate.a] && !b_is_used[candidate.b]) {
      a_is_used[candidate.a] = true;
      b_is_used[candidate.b] = true;
      pairs.emplace_back(candidate.a, candidate.b);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace vo
