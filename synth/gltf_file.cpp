#include "synth/gltf_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "synth/gltf.h"
#include "vo/core/error.h"

namespace synth {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using vo::fail;
using vo::require;

constexpr std::size_t kGlbHeader = 12;   // bytes: magic, version, length
constexpr std::size_t kChunkHeader = 8;  // bytes: length, type
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

/// glTF nests a few levels deep; extras may nest further. A limit keeps recursive readers safe.
constexpr int kDeepestNesting = 100;

/// The message of a JSON exception without its leading "[json.exception...] ".
std::string without_tag(const std::string& message) {
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

json parse_json(std::string_view text, const std::string& place) {
  const auto limit_depth = [&](int depth, json::parse_event_t, const json&) {
    require(depth <= kDeepestNesting, place, ": its JSON is nested more than ", kDeepestNesting,
            " levels deep, expected a glTF document");
    return true;
  };
  try {
    return json::parse(text, limit_depth);
  } catch (const json::exception& error) {
    fail(place, ": is not a glTF file, expected JSON: ", without_tag(error.what()));
  }
}

std::uint32_t read_uint32(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return static_cast<std::uint32_t>(bytes[offset]) |
         static_cast<std::uint32_t>(bytes[offset + 1]) << 8U |
         static_cast<std::uint32_t>(bytes[offset + 2]) << 16U |
         static_cast<std::uint32_t>(bytes[offset + 3]) << 24U;
}

std::string_view as_text(std::span<const std::uint8_t> bytes, std::size_t offset,
                         std::size_t size) {
  return {reinterpret_cast<const char*>(bytes.data()) + offset, size};
}

bool is_glb(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 4 && as_text(bytes, 0, 4) == "glTF";
}

/// Checks the header and returns the length it states.
std::size_t glb_length(std::span<const std::uint8_t> bytes, const std::string& place) {
  require(bytes.size() >= kGlbHeader + kChunkHeader, place, ": is a .glb of ", bytes.size(),
          " bytes, expected a header and a JSON chunk");
  const std::uint32_t version = read_uint32(bytes, 4);
  require(version == 2, place, ": is a .glb of version ", version, ", expected 2");
  const std::size_t length = read_uint32(bytes, 8);
  require(length >= kGlbHeader + kChunkHeader && length <= bytes.size(), place, ": is a .glb of ",
          bytes.size(), " bytes, expected the ", length, " bytes its header states");
  return length;
}

void read_glb(std::span<const std::uint8_t> bytes, GltfFile& file) {
  const std::string place = file.path.string();
  const std::size_t length = glb_length(bytes, place);
  std::size_t begin = kGlbHeader;
  for (int chunk = 0; length - begin >= kChunkHeader; ++chunk) {
    const std::size_t size = read_uint32(bytes, begin);
    const std::uint32_t type = read_uint32(bytes, begin + 4);
    begin += kChunkHeader;
    require(size <= length - begin, place, ": chunk ", chunk, " of the .glb states ", size,
            " bytes, expected at most the remaining ", length - begin);
    require(chunk > 0 || type == kJsonChunk, place,
            ": the first chunk of the .glb has another type, expected JSON");
    if (chunk == 0) {
      file.json = parse_json(as_text(bytes, begin, size), place);
    } else if (chunk == 1 && type == kBinaryChunk) {
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
      file.binary.assign(first, first + static_cast<std::ptrdiff_t>(size));
    }
    begin += size;
  }
}

std::optional<int> hex_digit(char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t digit = kDigits.find(lower);
  return digit == std::string_view::npos ? std::nullopt : std::optional(static_cast<int>(digit));
}

std::string percent_decode(const std::string& uri, const std::string& place) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      decoded += uri[i];
      continue;
    }
    const auto high = i + 2 < uri.size() ? hex_digit(uri[i + 1]) : std::nullopt;
    const auto low = i + 2 < uri.size() ? hex_digit(uri[i + 2]) : std::nullopt;
    require(high && low, place, ": uri \"", uri, "\" has a % without two hexadecimal digits");
    decoded += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  return decoded;
}

/// Whether it begins like "http:" or "C:".
bool has_scheme(const std::string& name) {
  const std::size_t end = name.find_first_of(":/");
  return end != std::string::npos && name[end] == ':';
}

/// A file as messages name it: after the element that refers to it, if any.
std::string named(const fs::path& path, const std::string& place) {
  return place.empty() ? path.string() : place + ": " + path.string();
}

bool has_control_character(const std::string& name) {
  return std::any_of(name.begin(), name.end(),
                     [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
}

}  // namespace

GltfFile read_gltf_file(const fs::path& path) {
  return parse_gltf_file(read_file(path, file_size(path, {}), {}), path);
}

GltfFile parse_gltf_file(std::span<const std::uint8_t> content, const fs::path& path) {
  GltfFile file;
  file.path = path;
  if (is_glb(content)) {
    read_glb(content, file);
  } else {
    file.json = parse_json(as_text(content, 0, content.size()), path.string());
  }
  return file;
}

bool is_data_uri(const std::string& uri) {
  return uri.compare(0, 5, "data:") == 0;
}

fs::path resolve_uri(const fs::path& folder, const std::string& uri, const std::string& place) {
  const std::string name = percent_decode(uri, place);
  require(!name.empty() && !has_control_character(name), place, ": uri \"", uri,
          "\" is no file name, expected a file in the scene's folder");
  require(!has_scheme(name), place, ": uri \"", uri.substr(0, 60),
          "\" has a scheme, expected a file in the scene's folder");
  const fs::path relative = fs::path(name).lexically_normal();
  const bool leaves =
      relative.is_absolute() || *relative.begin() == ".." || name.find('\\') != std::string::npos;
  require(!leaves, place, ": uri \"", uri,
          "\" leads out of the scene's folder, expected a file in it");
  return folder / relative;
}

Bytes read_file(const fs::path& path, std::size_t size, const std::string& place) {
  const std::size_t available = file_size(path, place);
  require(size <= kMostGltfBytes, named(path, place), " has ", size, " bytes, expected at most ",
          kMostGltfBytes);
  require(available >= size, named(path, place), " has ", available, " bytes, expected ", size);
  Bytes bytes(size);
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  require(stream.good(), named(path, place), " cannot be read, expected ", size, " bytes");
  return bytes;
}

std::size_t file_size(const fs::path& path, const std::string& place) {
  std::error_code error;
  require(fs::exists(path, error), named(path, place), " does not exist, expected a file");
  require(fs::is_regular_file(path, error), named(path, place),
          " is a folder or device, expected a file");
  const std::uintmax_t size = fs::file_size(path, error);
  require(!error, named(path, place), " cannot be read: ", error.message());
  return size;
}

}  // namespace synth
