#pragma once

#include <optional>
#include <string>

namespace tools {

/// What a request to the server says of where it comes from.
struct RequestSource {
  std::string host;                   ///< its header Host; empty without one
  std::optional<std::string> origin;  ///< its header Origin, which pages of browsers cannot forge
  std::string token;                  ///< of its URL; empty without one
};

/// Says who may speak to a server on 127.0.0.1: who knows its token, and no page of another origin.
/// A host that is not the server's own is refused, too, because a page of another site could have
/// its name resolved to 127.0.0.1 and would then be of the same origin.
class AccessRule {
 public:
  AccessRule(int port, std::string token);

  /// Returns why the request is refused, as a sentence; empty where it is allowed.
  std::string refusal(const RequestSource& source) const;

 private:
  bool is_own_host(const std::string& host) const;

  std::string port_;
  std::string token_;
};

/// Returns 32 hexadecimal digits that nobody can guess. Only who may see a page depends on them, no
/// result does.
std::string random_token();

}  // namespace tools
