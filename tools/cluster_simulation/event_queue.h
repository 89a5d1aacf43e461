#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace tools {

/// Events that have a time, earliest first; of several at one time, the one that was added first.
template <typename Event>
class EventQueue {
 public:
  void add(double time, const Event& event) { entries_.push({time, count_++, event}); }

  bool is_empty() const { return entries_.empty(); }

  /// The time of the first event; infinite if there is none.
  double time() const {
    return is_empty() ? std::numeric_limits<double>::infinity() : entries_.top().time;
  }

  const Event& first() const { return entries_.top().event; }

  void pop() { entries_.pop(); }

 private:
  struct Entry {
    double time;
    std::uint64_t number;
    Event event;

    bool operator<(const Entry& other) const {
      return std::tie(time, number) > std::tie(other.time, other.number);
    }
  };

  std::priority_queue<Entry> entries_;
  std::uint64_t count_ = 0;
};

}  // namespace tools
