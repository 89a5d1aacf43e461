#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace tools {

/// What viewers of a run are told, as server-sent events. Who tells never waits for who reads: what
/// is kept is read by each viewer at its own pace, what is replaced is there in its last form
/// alone.
class EventFeed {
 public:
  /// How far one viewer has read.
  struct Place {
    std::size_t kept = 0;                         ///< number of kept events that were read
    std::map<std::string, std::uint64_t> latest;  ///< version read of each replaced event
    bool has_end = false;                         ///< whether the last event was read
  };

  /// Tells an event that every viewer gets, also those who come later. `data` has no line break.
  void keep(const std::string& name, const std::string& data);

  /// Tells an event in place of the last one of this name, which whoever has not read it misses.
  void replace(const std::string& name, const std::string& data);

  /// Tells the last event, which every viewer gets after all others, those that are replaced, too.
  void end(const std::string& name, const std::string& data);

  /// Ends the feed: what was told can still be read.
  void close();

  /// Returns the events from a place on, at most about 256 kB of them, and moves the place; waits
  /// for some where there are none yet. Empty where the wait was in vain.
  std::string read(Place& place, std::chrono::milliseconds patience);

  /// Returns whether the feed is closed and all has been read from this place on.
  bool is_over(const Place& place) const;

  void join();   ///< a viewer begins to read
  void leave();  ///< a viewer has gone

  /// Returns once no viewer is left, or after that time.
  void wait_for_end(std::chrono::milliseconds patience);
  std::size_t viewers() const;

 private:
  struct Latest {
    std::uint64_t version = 0;
    std::string event;
  };

  bool has_news(const Place& place) const;
  bool has_end_for(const Place& place) const { return !place.has_end && !end_.empty(); }

  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::vector<std::string> kept_;
  std::map<std::string, Latest> latest_;
  std::string end_;  ///< empty as long as nothing ended
  std::size_t viewers_ = 0;
  bool is_closed_ = false;
};

}  // namespace tools
