#include "vo/geometry/associate.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace vo {
namespace {

/// The stamps of both lists that are not used yet, in one order of time. The closest pair is always
/// one of neighbours in it: any stamp between the two would be closer to one of them.
class UnusedStamps {
 public:
  using Node = std::uint32_t;
  static constexpr Node kNone = std::numeric_limits<Node>::max();

  UnusedStamps(std::span<const double> a, std::span<const double> b) : a_(a), b_(b) {
    const std::size_t count = a.size() + b.size();
    assert(count < kNone);
    order_.reserve(count);
    for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
      const bool is_a = j == b.size() || (i < a.size() && a[i] <= b[j]);
      order_.push_back(static_cast<Node>(is_a ? i++ : a.size() + j++));
    }
    is_used_.resize(count, false);
    for (std::size_t node = 0; node < count; ++node) {
      before_.push_back(node == 0 ? kNone : static_cast<Node>(node - 1));
      after_.push_back(node + 1 == count ? kNone : static_cast<Node>(node + 1));
    }
  }

  std::size_t size() const { return order_.size(); }
  bool is_a(Node node) const { return order_[node] < a_.size(); }
  Node before(Node node) const { return before_[node]; }
  Node after(Node node) const { return after_[node]; }

  bool is_used(Node node) const { return is_used_[node]; }
  double stamp(Node node) const { return is_a(node) ? a_[index(node)] : b_[index(node)]; }

  /// Returns (index in a, index in b) of two stamps of different lists.
  std::pair<std::size_t, std::size_t> indices(Node x, Node y) const {
    return is_a(x) ? std::pair(index(x), index(y)) : std::pair(index(y), index(x));
  }

  void use(Node node) {
    if (before_[node] != kNone) {
      after_[before_[node]] = after_[node];
    }
    if (after_[node] != kNone) {
      before_[after_[node]] = before_[node];
    }
    is_used_[node] = true;
  }

 private:
  std::size_t index(Node node) const {
    return is_a(node) ? order_[node] : order_[node] - a_.size();
  }

  std::span<const double> a_, b_;
  std::vector<Node> order_;  ///< index in a, or that in b plus the size of a
  std::vector<Node> before_, after_;
  std::vector<bool> is_used_;
};

/// Two neighbours of different lists.
struct Pair {
  double difference;
  UnusedStamps::Node left;
  UnusedStamps::Node right;
};

/// Takes the closest pairs out of two lists of stamps, one after the other.
class ClosestPairs {
 public:
  ClosestPairs(std::span<const double> a, std::span<const double> b, double max_difference)
      : stamps_(a, b), max_difference_(max_difference) {
    for (std::size_t node = 0; node + 1 < stamps_.size(); ++node) {
      add(static_cast<Node>(node), static_cast<Node>(node + 1));
    }
  }

  std::vector<std::pair<std::size_t, std::size_t>> take_all() {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    while (!closest_.empty()) {
      const Pair pair = closest_.top();
      closest_.pop();
      if (stamps_.is_used(pair.left) || stamps_.is_used(pair.right)) {
        continue;
      }
      pairs.push_back(stamps_.indices(pair.left, pair.right));
      const Node left = stamps_.before(pair.left);
      const Node right = stamps_.after(pair.right);
      stamps_.use(pair.left);
      stamps_.use(pair.right);
      if (left != UnusedStamps::kNone && right != UnusedStamps::kNone) {
        add(left, right);
      }
    }
    return pairs;
  }

 private:
  using Node = UnusedStamps::Node;

  /// Orders pairs by their difference, equal ones by the indices of their stamps.
  struct IsLater {
    const UnusedStamps& stamps;

    bool operator()(const Pair& x, const Pair& y) const {
      return x.difference != y.difference
                 ? x.difference > y.difference
                 : stamps.indices(x.left, x.right) > stamps.indices(y.left, y.right);
    }
  };

  void add(Node left, Node right) {
    const double difference = stamps_.stamp(right) - stamps_.stamp(left);
    const bool is_close = difference < max_difference_ || difference == 0;
    if (stamps_.is_a(left) != stamps_.is_a(right) && is_close) {
      closest_.push({difference, left, right});
    }
  }

  UnusedStamps stamps_;
  double max_difference_;
  std::priority_queue<Pair, std::vector<Pair>, IsLater> closest_{IsLater{stamps_}};
};

}  // namespace

std::vector<double> timestamps_of(const Trajectory& trajectory, double offset) {
  std::vector<double> timestamps;
  timestamps.reserve(trajectory.size());
  for (const StampedPose& pose : trajectory) {
    timestamps.push_back(pose.timestamp + offset);
  }
  return timestamps;
}

std::vector<std::pair<std::size_t, std::size_t>> associate(std::span<const double> a,
                                                           std::span<const double> b,
                                                           double max_difference) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs =
      ClosestPairs(a, b, max_difference).take_all();
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace vo
