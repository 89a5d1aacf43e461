#include "synth/gltf_document/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

#include "vo/core/error.h"
#include "vo/files/ranged_file.h"
#include "vo/text_files/json_limits.h"

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

/// Returns the message of a JSON exception without its leading "[json.exception...] ".
std::string without_tag(const std::string& message) {
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

/// Converts a whole number that is written like 3.0 or 30e-1, as glTF allows, to an integer.
void make_whole(json& value) {
  constexpr double kMostExact = 9007199254740992;  // 2^53
  const double number = value.get<double>();
  if (number >= 0 && number <= kMostExact && std::trunc(number) == number) {
    value = static_cast<std::uint64_t>(number);
  }
}

/// Does so with all numbers of a document, which is nested no deeper than its limits allow.
void make_all_whole(json& document) {
  if (document.is_number_float()) {
    make_whole(document);
  } else if (document.is_structured()) {
    std::for_each(document.begin(), document.end(), make_all_whole);
  }
}

json parse_json(std::string_view text, const std::string& place) {
  vo::require_json_within_limits(text, place);
  try {
    // The parser's callback could do it, too, but takes time that is quadratic in an array's
    // length.
    json document = json::parse(text);
    make_all_whole(document);
    return document;
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

/// Checks the header of a .glb and returns the length, bytes, that it states.
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

/// Checks a .glb chunk (glTF 2.0, 4.4.3): JSON is first, BIN second or absent; others may follow.
void check_chunk(int chunk, std::uint32_t type, std::size_t size, const std::string& place) {
  const auto require_chunk = [&](bool is_right, const char* message) {
    require(is_right, place, ": chunk ", chunk, " of the .glb ", message);
  };
  require_chunk(size % 4 == 0, "has a length that is not aligned, expected a multiple of 4");
  require_chunk((chunk == 0) == (type == kJsonChunk),
                "has another type, expected JSON as the first and only there");
  require_chunk(type != kBinaryChunk || chunk == 1, "is BIN, expected it as the second alone");
  require_chunk(type != kBinaryChunk || size > 0, "is BIN and empty, expected bytes or no chunk");
}

void read_glb(std::span<const std::uint8_t> bytes, GltfFile& file) {
  const std::string place = file.path.string();
  const std::size_t length = glb_length(bytes, place);
  std::size_t begin = kGlbHeader;
  for (int chunk = 0; begin < length; ++chunk) {
    require(length - begin >= kChunkHeader, place, ": ends in the header of chunk ", chunk,
            " of the .glb, expected ", kChunkHeader, " bytes");
    const std::size_t size = read_uint32(bytes, begin);
    const std::uint32_t type = read_uint32(bytes, begin + 4);
    begin += kChunkHeader;
    require(size <= length - begin, place, ": chunk ", chunk, " of the .glb states ", size,
            " bytes, expected at most the remaining ", length - begin);
    check_chunk(chunk, type, size, place);
    if (chunk == 0) {
      file.json = parse_json(as_text(bytes, begin, size), place);
    } else if (type == kBinaryChunk) {
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
      file.binary.assign(first, first + static_cast<std::ptrdiff_t>(size));
    }
    begin += size;
  }
}

/// Returns a file's name for messages, after the element that refers to it, if any.
std::string named(const fs::path& path, const std::string& place) {
  return place.empty() ? path.string() : place + ": " + path.string();
}

}  // namespace

GltfFile read_gltf_file(const fs::path& path) {
  return parse_gltf_file(read_file(path, file_size(path, {}), {}), path);
}

GltfFile parse_gltf_file(std::span<const std::uint8_t> content, const fs::path& path) {
  GltfFile file;
  file.path = path;
  file.is_glb = is_glb(content);
  if (file.is_glb) {
    read_glb(content, file);
  } else {
    file.json = parse_json(as_text(content, 0, content.size()), path.string());
  }
  return file;
}

Bytes read_file(const fs::path& path, std::size_t size, const std::string& place) {
  const std::size_t available = file_size(path, place);
  require(size <= kMostGltfBytes, named(path, place), " has ", size, " bytes, expected at most ",
          kMostGltfBytes);
  require(available >= size, named(path, place), " has ", available, " bytes, expected ", size);
  const std::string bytes = vo::RangedFile(path).read(0, size);
  require(bytes.size() == size, named(path, place), " ended after ", bytes.size(),
          " bytes, expected ", size);
  return {bytes.begin(), bytes.end()};
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
