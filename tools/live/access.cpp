#include "tools/live/access.h"

#include <array>
#include <cstddef>
#include <random>
#include <utility>

namespace tools {
namespace {

constexpr const char* kScheme = "http://";

/// Returns whether two texts are equal, in a time that does not tell where they differ.
bool are_equal(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

}  // namespace

AccessRule::AccessRule(int port, std::string token)
    : port_(std::to_string(port)), token_(std::move(token)) {}

bool AccessRule::is_own_host(const std::string& host) const {
  return host == "127.0.0.1:" + port_ || host == "localhost:" + port_;
}

std::string AccessRule::refusal(const RequestSource& source) const {
  if (!is_own_host(source.host)) {
    return "the host is not this server's, expected 127.0.0.1:" + port_;
  }
  if (source.origin && *source.origin != kScheme + source.host) {
    return "the origin is another page's, expected " + std::string(kScheme) + source.host;
  }
  if (!are_equal(source.token, token_)) {
    return "the token is wrong, expected the one of the URL that the program has printed";
  }
  return "";
}

std::string random_token() {
  constexpr std::size_t kDigits = 32;
  constexpr std::array<char, 17> kHex{"0123456789abcdef"};
  std::random_device source;
  std::uniform_int_distribution<std::size_t> digit(0, 15);
  std::string token;
  while (token.size() < kDigits) {
    token += kHex.at(digit(source));
  }
  return token;
}

}  // namespace tools
