#include "tools/live/live_server.h"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <ctime>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <httplib.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include "tools/live/access.h"
#include "tools/live/event_feed.h"
#include "tools/live/pause_gate.h"
#include "vo/core/error.h"

namespace tools {
namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kThreads = 8;
constexpr std::size_t kMostViewers = 4;    // each holds a thread
constexpr std::size_t kMostPosted = 1024;  // of what is posted: there is nothing to say
constexpr std::chrono::milliseconds kHeartbeat(500);
constexpr std::chrono::milliseconds kFarewell(3000);
constexpr int kLowPriority = 10;

/// Nothing but the page's own contents and this server's events may be loaded.
constexpr const char* kPolicy =
    "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src "
    "'unsafe-inline'; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors "
    "'none'";

/// Leaves signals to the thread that runs the program, also the one of a viewer who has gone, and
/// the processor to whoever needs it more. Threads that this one starts are alike.
void step_back() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP}) {
    ::sigaddset(&signals, signal);
  }
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  ::setpriority(PRIO_PROCESS, 0, kLowPriority);
}

RequestSource source_of(const Request& request) {
  RequestSource source{.host = request.get_header_value("Host"),
                       .origin = std::nullopt,
                       .token = request.get_param_value("token")};
  if (request.has_header("Origin")) {
    source.origin = request.get_header_value("Origin");
  }
  return source;
}

void answer(Response& response, int status, const std::string& text) {
  response.status = status;
  response.set_content(text + "\n", "text/plain; charset=utf-8");
}

/// Tells all viewers whether the run is held up.
void tell(EventFeed& feed, const PauseGate& gate) {
  feed.replace("gate", gate.is_paused() ? R"({"paused":true})" : R"({"paused":false})");
}

/// A viewer of the feed, from its first event on until it has gone.
class Viewer {
 public:
  Viewer(EventFeed& feed, PauseGate* gate) : feed_(feed), gate_(gate) { feed_.join(); }
  ~Viewer() {
    feed_.leave();
    if (gate_ != nullptr && feed_.viewers() == 0) {
      gate_->resume();
      tell(feed_, *gate_);
    }
  }
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;
  Viewer(Viewer&&) = delete;
  Viewer& operator=(Viewer&&) = delete;

  /// Sends what is new, or that there is nothing. Returns false when the viewer has gone.
  bool send(httplib::DataSink& sink) {
    const std::string text = feed_.read(place_, kHeartbeat);
    if (text.empty() && feed_.is_over(place_)) {
      sink.done();
      return true;
    }
    const std::string said = text.empty() ? ":\n\n" : text;
    return sink.write(said.data(), said.size());
  }

 private:
  EventFeed& feed_;
  PauseGate* gate_;
  EventFeed::Place place_;
};

void tell_events(EventFeed& feed, PauseGate* gate, Response& response) {
  if (feed.viewers() >= kMostViewers) {
    answer(response, 503, "the run has as many viewers as it can have");
    return;
  }
  const auto viewer = std::make_shared<Viewer>(feed, gate);
  response.set_chunked_content_provider(
      "text/event-stream",
      [viewer](std::size_t, httplib::DataSink& sink) { return viewer->send(sink); });
}

}  // namespace

struct LiveServer::Serving {
  LiveContent content;
  httplib::Server server;
  AccessRule rule{0, ""};
  std::thread thread;

  /// Makes a server, and keeps what SIGPIPE does, which the library changes for the whole program.
  static std::unique_ptr<Serving> made() {
    struct sigaction before {};
    ::sigaction(SIGPIPE, nullptr, &before);
    auto serving = std::make_unique<Serving>();
    ::sigaction(SIGPIPE, &before, nullptr);
    return serving;
  }

  httplib::Server::HandlerResponse judge(const Request& request, Response& response) const {
    if (const std::string refusal = rule.refusal(source_of(request)); !refusal.empty()) {
      answer(response, 403, refusal);
      return httplib::Server::HandlerResponse::Handled;
    }
    const bool is_move =
        request.method == "POST" && content.gate != nullptr &&
        (request.path == "/pause" || request.path == "/resume" || request.path == "/step");
    if (!is_move && request.method != "GET" && request.method != "HEAD") {
      response.set_header("Allow", "GET, HEAD");
      answer(response, 405, "only pause, resume and step can be posted, and only to a run");
      return httplib::Server::HandlerResponse::Handled;
    }
    return httplib::Server::HandlerResponse::Unhandled;
  }

  void on_move(const std::string& path, void (PauseGate::*move)()) {
    server.Post(path, [this, move](const Request&, Response& response) {
      (content.gate->*move)();
      answer(response, 200, content.gate->is_paused() ? "paused" : "running");
      if (content.feed != nullptr) {
        tell(*content.feed, *content.gate);
      }
    });
  }

  void add_handlers() {
    server.set_default_headers({{"Cache-Control", "no-store"},
                                {"Content-Security-Policy", kPolicy},
                                {"Cross-Origin-Resource-Policy", "same-origin"},
                                {"Referrer-Policy", "no-referrer"},
                                {"X-Content-Type-Options", "nosniff"},
                                {"X-Frame-Options", "DENY"}});
    server.set_pre_routing_handler(
        [this](const Request& request, Response& response) { return judge(request, response); });
    server.Get("/", [this](const Request&, Response& response) {
      // From a provider, because the library would compress a text, for seconds.
      response.set_content_provider(
          content.page.size(), "text/html; charset=utf-8",
          [this](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
            return sink.write(content.page.data() + offset, length);
          });
    });
    if (content.feed != nullptr) {
      server.Get("/events", [this](const Request&, Response& response) {
        tell_events(*content.feed, content.gate, response);
      });
    }
    if (content.gate != nullptr) {
      on_move("/pause", &PauseGate::pause);
      on_move("/resume", &PauseGate::resume);
      on_move("/step", &PauseGate::step);
    }
  }

  /// Sets limits that a page on the same machine never meets.
  void set_limits() {
    constexpr time_t kPatience = 5;  // s, for one who neither speaks nor reads
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the server deletes it
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_payload_max_length(kMostPosted);
    server.set_read_timeout(kPatience);
    server.set_write_timeout(kPatience);
    server.set_keep_alive_timeout(kPatience);
    // The library's own would let another process listen at the same port.
    server.set_socket_options([](auto socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
  }

  /// Returns the port that is listened at.
  int bind(const LivePort& port) {
    int bound = port.number;
    if (bound == 0) {
      bound = server.bind_to_any_port(kHost);
    } else if (!server.bind_to_port(kHost, bound)) {
      bound = -1;
    }
    vo::require(bound > 0, port.option, port.number,
                ": the port is taken or not allowed, expected one that is free; 0 is any");
    return bound;
  }

  void listen() {
    thread = std::thread([this] {
      step_back();
      server.listen_after_bind();
    });
    while (!server.is_running()) {
      std::this_thread::yield();
    }
  }
};

LiveServer::LiveServer(const LiveContent& content, const LivePort& port)
    : serving_(Serving::made()) {
  serving_->content = content;
  serving_->set_limits();
  serving_->add_handlers();
  const int bound = serving_->bind(port);
  const std::string token = random_token();
  serving_->rule = AccessRule(bound, token);
  url_ = vo::concat("http://", kHost, ":", bound, "/?token=", token);
  serving_->listen();
}

LiveServer::~LiveServer() {
  if (serving_->content.feed != nullptr) {
    serving_->content.feed->close();
    serving_->content.feed->wait_for_end(kFarewell);
  }
  serving_->server.stop();
  serving_->thread.join();
}

}  // namespace tools
