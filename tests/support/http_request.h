#pragma once

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace support {

/// A connection to a server on 127.0.0.1, closed at the end.
class Connection {
 public:
  explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      ::close(socket_);
      throw std::runtime_error("nobody listens at the port");
    }
  }
  ~Connection() { ::close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  Connection(Connection&&) = delete;
  Connection& operator=(Connection&&) = delete;

  void send(const std::string& text) const {
    ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
  }

  /// Returns what arrives until `end` has arrived, or all until the server closes the connection.
  std::string read_until(const std::string& end) const {
    std::string text;
    std::string piece(4096, '\0');
    while (end.empty() || text.find(end) == std::string::npos) {
      const ssize_t count = ::recv(socket_, piece.data(), piece.size(), 0);
      if (count <= 0) {
        break;
      }
      text.append(piece, 0, static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int socket_;
};

/// A URL as `http://127.0.0.1:8080/?token=ab` taken apart.
struct LocalUrl {
  int port = 0;
  std::string query;  ///< with its question mark

  explicit LocalUrl(const std::string& url) {
    const std::size_t colon = url.rfind(':');
    const std::size_t slash = url.find('/', colon);
    port = std::stoi(url.substr(colon + 1, slash - colon - 1));
    query = url.substr(slash + 1);
  }

  std::string host() const { return "127.0.0.1:" + std::to_string(port); }
};

/// Returns the text of a request with these headers, each with its line break.
inline std::string request_text(const std::string& method, const std::string& target,
                                const std::string& headers) {
  return method + " " + target + " HTTP/1.1\r\n" + headers +
         "Content-Length: 0\r\nConnection: close\r\n\r\n";
}

/// Sends a request and returns the whole answer.
inline std::string answer_to(int port, const std::string& request) {
  const Connection connection(port);
  connection.send(request);
  return connection.read_until("");
}

/// Returns the status of an answer.
inline int status_of(const std::string& answer) {
  const std::size_t space = answer.find(' ');
  return space == std::string::npos ? 0 : std::stoi(answer.substr(space + 1, 3));
}

}  // namespace support
