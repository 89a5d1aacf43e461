#include "tools/watch/page_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <exception>
#include <optional>

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/live/event_feed.h"
#include "tools/live/live_server.h"
#include "tools/watch/watch_page.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::size_t kMostBytes = 64'000;  // of one message
constexpr char kSuccess = '+';              // before the URL; before an error is its kind's digit

/// Returns the next message; empty where there are no more.
std::optional<std::string> received(int socket) {
  std::string message(kMostBytes, '\0');
  ssize_t count = 0;
  do {
    count = ::recv(socket, message.data(), message.size(), 0);
  } while (count < 0 && errno == EINTR);
  if (count <= 0) {
    return std::nullopt;
  }
  message.resize(static_cast<std::size_t>(count));
  return message;
}

void say(int socket, const std::string& message) {
  ::send(socket, message.data(), std::min(message.size(), kMostBytes), MSG_NOSIGNAL | MSG_DONTWAIT);
}

/// Tells the feed what the run says, until it has ended.
void pass_on(int socket, EventFeed& feed) {
  while (const std::optional<std::string> message = received(socket)) {
    const std::size_t space = message->find(' ');
    const std::string name = message->substr(1, space - 1);
    const std::string data = message->substr(space + 1);
    message->front() == 'k' ? feed.keep(name, data) : feed.replace(name, data);
  }
}

/// Serves the page until the run has ended, however it has; what interrupts the run does not
/// interrupt the page, so that it can say so.
[[noreturn]] void serve(int socket, int port) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::signal(signal, SIG_IGN);
  }
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    EventFeed feed;
    const LiveServer server({.page = watch_page(), .feed = &feed}, {port});
    say(socket, kSuccess + server.url());
    pass_on(socket, feed);
  } catch (const vo::Error& error) {
    say(socket, std::to_string(static_cast<int>(error.kind())) + error.what());
  } catch (const std::exception& error) {
    say(socket, std::to_string(static_cast<int>(vo::ErrorKind::temporary)) + error.what());
  }
  ::_exit(0);
}

}  // namespace

PageProcess::PageProcess(int port) {
  std::array<int, 2> sockets{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0) {
    vo::fail_as(vo::ErrorKind::temporary, "--live: no socket can be had");
  }
  process_ = ::fork();
  if (process_ == 0) {
    ::close(sockets[0]);
    serve(sockets[1], port);
  }
  ::close(sockets[1]);
  socket_ = sockets[0];
  if (process_ < 0) {
    ::close(socket_);
    vo::fail_as(vo::ErrorKind::temporary, "--live: no process can be had for the page");
  }
  const std::string answer = received(socket_).value_or("3the process of the page has ended");
  url_ = answer.substr(1);
  if (answer.front() != kSuccess) {
    ::close(socket_);
    ::waitpid(process_, nullptr, 0);
    throw vo::Error(url_, static_cast<vo::ErrorKind>(answer.front() - '0'));
  }
}

PageProcess::~PageProcess() {
  ::close(socket_);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void PageProcess::send(char kind, const std::string& name, const std::string& data) const {
  const std::string message = kind + name + " " + data;
  if (message.size() <= kMostBytes) {
    say(socket_, message);
  }
}

}  // namespace tools
