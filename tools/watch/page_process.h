#pragma once

#include <string>

#include <sys/types.h>

namespace tools {

/// A page as RunWatch serves it, of a process of its own: for a program that forks others and may
/// therefore have no second thread. Nobody can hold such a run up.
class PageProcess {
 public:
  /// Forks the process, while this one has one thread. Port 0 is any that is free. Throws as
  /// LiveServer does.
  explicit PageProcess(int port);
  ~PageProcess();  ///< lets the viewers read what was told, within seconds
  PageProcess(const PageProcess&) = delete;
  PageProcess& operator=(const PageProcess&) = delete;
  PageProcess(PageProcess&&) = delete;
  PageProcess& operator=(PageProcess&&) = delete;

  const std::string& url() const { return url_; }

  /// Tells an event as EventFeed::keep does. It is left out where the page's process does not keep
  /// up; `data` has no line break.
  void keep(const std::string& name, const std::string& data) { send('k', name, data); }

  /// Tells an event as EventFeed::replace does, likewise.
  void replace(const std::string& name, const std::string& data) { send('r', name, data); }

 private:
  void send(char kind, const std::string& name, const std::string& data) const;

  int socket_ = -1;
  pid_t process_ = -1;
  std::string url_;
};

}  // namespace tools
