#include "synth/gltf_document/uri.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "vo/core/error.h"
#include "vo/files/input.h"

namespace synth {
namespace {

namespace fs = std::filesystem;
using vo::require;

constexpr std::string_view kDataScheme = "data:";

/// Returns the beginning of a URI for messages, as data URIs may be long.
std::string shortened(const std::string& uri) {
  return uri.substr(0, 60);
}

std::optional<int> hex_digit(char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t digit = kDigits.find(lower);
  return digit == std::string_view::npos ? std::nullopt : std::optional(static_cast<int>(digit));
}

std::string percent_decode(const std::string& uri, const std::string& place) {
  std::string decoded;
  decoded.reserve(uri.size());
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      decoded += uri[i];
      continue;
    }
    const auto high = i + 2 < uri.size() ? hex_digit(uri[i + 1]) : std::nullopt;
    const auto low = i + 2 < uri.size() ? hex_digit(uri[i + 2]) : std::nullopt;
    require(high && low, place, ": uri \"", shortened(uri),
            "\" has a % without two hexadecimal digits");
    decoded += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  return decoded;
}

/// Returns the six bits of a base64 or base64url character; nothing for any other character.
std::optional<unsigned> base64_digit(char c) {
  const auto after = [c](char first) { return static_cast<unsigned>(c - first); };
  if (c >= 'A' && c <= 'Z') {
    return after('A');
  }
  if (c >= 'a' && c <= 'z') {
    return 26U + after('a');
  }
  if (c >= '0' && c <= '9') {
    return 52U + after('0');
  }
  if (c == '+' || c == '-') {
    return 62U;
  }
  return c == '/' || c == '_' ? std::optional(63U) : std::nullopt;
}

Bytes decode_base64(std::string_view text, const std::string& place) {
  for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding) {
    text.remove_suffix(1);
  }
  require(text.size() % 4 != 1, place, ": its data URI ends in the middle of a byte of base64");
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  unsigned bits = 0;
  unsigned count = 0;  // bits that are not in a byte yet
  for (const char c : text) {
    const std::optional<unsigned> digit = base64_digit(c);
    require(digit.has_value(), place, ": its data URI has '", c, "', expected base64");
    bits = (bits << 6U | *digit) & 0xFFFU;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
  }
  return bytes;
}

/// Returns whether a name begins with a scheme or drive, like "http:" or "C:".
bool has_scheme(const std::string& name) {
  const std::size_t end = name.find_first_of(":/");
  return end != std::string::npos && name[end] == ':';
}

bool has_control_character(const std::string& name) {
  return std::any_of(name.begin(), name.end(),
                     [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
}

}  // namespace

bool is_data_uri(const std::string& uri) {
  return uri.compare(0, kDataScheme.size(), kDataScheme) == 0;
}

UriData decode_data_uri(const std::string& uri, const std::string& place) {
  const std::size_t comma = uri.find(',');
  require(comma != std::string::npos, place, ": its data URI \"", shortened(uri),
          "\" has no comma, expected data after one");
  const std::string header = uri.substr(kDataScheme.size(), comma - kDataScheme.size());
  require(header.find(";;") == std::string::npos, place, ": its data URI \"", shortened(uri),
          "\" has an empty parameter, expected one like \";base64\"");
  constexpr std::string_view kBase64 = ";base64";
  const bool is_base64 =
      header.size() >= kBase64.size() &&
      header.compare(header.size() - kBase64.size(), kBase64.size(), kBase64) == 0;
  const std::string text = percent_decode(uri.substr(comma + 1), place);
  return {header.substr(0, header.find(';')),
          is_base64 ? decode_base64(text, place) : Bytes(text.begin(), text.end())};
}

fs::path resolve_uri(const fs::path& folder, const std::string& uri, const std::string& place) {
  const std::string name = percent_decode(uri, place);
  require(!name.empty() && !has_control_character(name), place, ": uri \"", uri,
          "\" is no file name, expected a file in the scene's folder");
  require(!has_scheme(name), place, ": uri \"", shortened(uri),
          "\" has a scheme, expected a file in the scene's folder");
  const fs::path relative = fs::path(name).lexically_normal();
  const bool leaves =
      relative.is_absolute() || *relative.begin() == ".." || name.find('\\') != std::string::npos;
  require(!leaves, place, ": uri \"", uri,
          "\" leads out of the scene's folder, expected a file in it");
  require(!vo::leads_out(folder, relative), place, ": uri \"", uri,
          "\" leads by a symbolic link out of the scene's folder, expected a file in it");
  require(folder != fs::path(vo::kStdinPath).parent_path(), place, ": uri \"", uri,
          "\" names a file beside the scene, which has no folder when it is read from a stream; "
          "expected a .glb or data: in the URIs");
  return folder / relative;
}

}  // namespace synth
