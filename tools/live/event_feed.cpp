#include "tools/live/event_feed.h"

#include <algorithm>

namespace tools {
namespace {

constexpr std::size_t kMostBytes = 256'000;  // of one reading

std::string as_event(const std::string& name, const std::string& data) {
  return "event: " + name + "\ndata: " + data + "\n\n";
}

}  // namespace

void EventFeed::keep(const std::string& name, const std::string& data) {
  const std::lock_guard lock(mutex_);
  kept_.push_back(as_event(name, data));
  news_.notify_all();
}

void EventFeed::replace(const std::string& name, const std::string& data) {
  std::string event = as_event(name, data);
  const std::lock_guard lock(mutex_);
  Latest& latest = latest_[name];
  ++latest.version;
  latest.event.swap(event);
  news_.notify_all();
}

void EventFeed::end(const std::string& name, const std::string& data) {
  std::string event = as_event(name, data);
  const std::lock_guard lock(mutex_);
  end_.swap(event);
  news_.notify_all();
}

void EventFeed::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  news_.notify_all();
}

std::string EventFeed::read(Place& place, std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, patience, [&] { return is_closed_ || has_news(place); });
  std::string text;
  while (place.kept < kept_.size() && text.size() < kMostBytes) {
    text += kept_[place.kept++];
  }
  if (place.kept < kept_.size()) {
    return text;  // what is replaced refers to what is kept: it comes after
  }
  for (const auto& [name, latest] : latest_) {
    if (place.latest[name] != latest.version) {
      place.latest[name] = latest.version;
      text += latest.event;
    }
  }
  if (has_end_for(place)) {
    place.has_end = true;
    text += end_;
  }
  return text;
}

bool EventFeed::is_over(const Place& place) const {
  const std::lock_guard lock(mutex_);
  return is_closed_ && !has_news(place);
}

void EventFeed::join() {
  const std::lock_guard lock(mutex_);
  ++viewers_;
}

void EventFeed::leave() {
  const std::lock_guard lock(mutex_);
  --viewers_;
  news_.notify_all();
}

void EventFeed::wait_for_end(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, patience, [this] { return viewers_ == 0; });
}

std::size_t EventFeed::viewers() const {
  const std::lock_guard lock(mutex_);
  return viewers_;
}

bool EventFeed::has_news(const Place& place) const {
  return place.kept < kept_.size() || has_end_for(place) ||
         std::any_of(latest_.begin(), latest_.end(), [&](const auto& entry) {
           const auto read = place.latest.find(entry.first);
           return read == place.latest.end() || read->second != entry.second.version;
         });
}

}  // namespace tools
