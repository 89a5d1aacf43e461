#pragma once

#include <memory>
#include <string>

namespace tools {

class EventFeed;
class PauseGate;

/// What a LiveServer serves. Feed and gate must outlive the server.
struct LiveContent {
  std::string page;           ///< HTML
  EventFeed* feed = nullptr;  ///< what the page is told; null where it is told nothing
  PauseGate* gate = nullptr;  ///< what the page may hold up; null for nothing
};

/// The port of a page, and what precedes it on the command line, for errors.
struct LivePort {
  int number = 0;  ///< 0 is any that is free
  std::string option = "--live=";
};

/// Serves one page on 127.0.0.1, in threads of low priority, to who knows its URL: GET / is the
/// page, GET /events the feed as server-sent events, and POST /pause, /resume and /step move the
/// gate, of which the feed is told as event `gate`. Nothing else can be read, nothing be written. A
/// request without the URL's token, from a page of another origin or to another host gets 403; a
/// method that has no meaning 405. When the last viewer goes, the gate opens.
class LiveServer {
 public:
  /// Throws vo::Error where the port is taken, and of kind usage where the program was built
  /// without an HTTP library.
  LiveServer(const LiveContent& content, const LivePort& port);
  ~LiveServer();  ///< closes the feed, and lets the viewers read what is left, within seconds
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;
  LiveServer(LiveServer&&) = delete;
  LiveServer& operator=(LiveServer&&) = delete;

  const std::string& url() const { return url_; }  ///< of the page, with its token

 private:
  struct Serving;

  std::unique_ptr<Serving> serving_;
  std::string url_;
};

}  // namespace tools
