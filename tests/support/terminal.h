#pragma once

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

namespace support {

/// A TerminalResult holds how a program ended and what it wrote on a terminal.
struct TerminalResult {
  int exit_code = 0;
  std::string screen;  ///< all bytes, as the program wrote them
};

/// A pseudo-terminal that changes no byte.
class Terminal {
 public:
  Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    const bool is_open = master_ >= 0 && ::grantpt(master_) == 0 && ::unlockpt(master_) == 0;
    std::array<char, 128> name{};
    if (!is_open || ::ptsname_r(master_, name.data(), name.size()) != 0) {
      throw std::runtime_error("there is no pseudo-terminal");
    }
    slave_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    ::tcgetattr(slave_, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(slave_, TCSANOW, &settings);
  }
  ~Terminal() {
    close_slave();
    ::close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  Terminal(Terminal&&) = delete;
  Terminal& operator=(Terminal&&) = delete;

  int slave() const { return slave_; }

  void close_slave() {
    if (slave_ >= 0) {
      ::close(slave_);
      slave_ = -1;
    }
  }

  /// Reads until nobody has the terminal open.
  std::string read_all() const {
    std::string text;
    std::array<char, 4096> part{};
    for (;;) {
      const ssize_t count = ::read(master_, part.data(), part.size());
      if (count > 0) {
        text.append(part.data(), static_cast<std::size_t>(count));
      } else if (count == 0 || errno != EINTR) {
        return text;
      }
    }
  }

 private:
  int master_ = -1;
  int slave_ = -1;
};

/// Runs the program with arguments as a shell reads them, stdout and stderr a terminal where the
/// arguments do not redirect them. `before` prepares the shell: `NO_COLOR=1 `.
inline TerminalResult run_on_terminal(const std::string& arguments,
                                      const std::string& before = "") {
  const std::string command = "unset NO_COLOR CLICOLOR_FORCE; TERM=xterm; export TERM; " + before +
                              "'" + EDVO_PROGRAM + "' " + arguments;
  Terminal terminal;
  const pid_t process = ::fork();
  if (process == 0) {
    ::dup2(terminal.slave(), STDOUT_FILENO);
    ::dup2(terminal.slave(), STDERR_FILENO);
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  terminal.close_slave();
  TerminalResult result{.exit_code = -1, .screen = terminal.read_all()};
  int status = 0;
  ::waitpid(process, &status, 0);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// Returns a text without its colours (`ESC [ NUMBERS m`).
inline std::string without_colours(std::string text) {
  for (std::size_t start = text.find("\033["); start != std::string::npos;
       start = text.find("\033[", start)) {
    const std::size_t end = text.find_first_not_of("0123456789;", start + 2);
    if (end == std::string::npos || text[end] != 'm') {
      start += 2;
    } else {
      text.erase(start, end + 1 - start);
    }
  }
  return text;
}

}  // namespace support
