#include "tools/studies/shapley.h"

#include <bit>
#include <cstddef>

namespace tools {
namespace {

/// Returns the share of all orders of the players in which exactly a given set of `before` players
/// precedes a given player.
double share_of_orders(int before, int players) {
  double share = 1.0 / players;
  for (int i = 1; i <= before; ++i) {
    share *= static_cast<double>(i) / (players - i);
  }
  return share;
}

}  // namespace

std::vector<double> shapley_values(int players, const std::function<double(std::uint32_t)>& value) {
  const std::uint32_t sets = std::uint32_t{1} << players;
  std::vector<double> values;
  for (std::uint32_t set = 0; set < sets; ++set) {
    values.push_back(value(set));
  }
  std::vector<double> shares(static_cast<std::size_t>(players), 0);
  for (int player = 0; player < players; ++player) {
    const std::uint32_t bit = std::uint32_t{1} << player;
    for (std::uint32_t set = 0; set < sets; ++set) {
      if ((set & bit) == 0) {
        shares[static_cast<std::size_t>(player)] +=
            share_of_orders(std::popcount(set), players) * (values[set | bit] - values[set]);
      }
    }
  }
  return shares;
}

}  // namespace tools
