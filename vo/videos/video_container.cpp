#include "vo/videos/video_container.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "vo/files/ranged_file.h"

namespace vo {
namespace {

using namespace std::string_view_literals;

constexpr auto kEbml = "\x1A\x45\xDF\xA3"sv;
constexpr auto kSegment = "\x18\x53\x80\x67"sv;

/// Types of the first box of an MP4 or QuickTime file.
constexpr std::array kFirstBoxes = {"ftyp"sv, "moov"sv, "mdat"sv, "wide"sv};

/// Returns a number of whole bytes, the greatest first.
std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (const char byte : bytes) {
    number = number << 8 | static_cast<unsigned char>(byte);
  }
  return number;
}

std::uint64_t little_endian(std::string_view bytes) {
  return big_endian(std::string(bytes.rbegin(), bytes.rend()));
}

std::optional<VideoContainer> container_of(const RangedFile& file) {
  const std::string begin = file.read(0, 12);
  if (begin.size() < 12) {
    return std::nullopt;
  }
  if (begin.starts_with("RIFF") && begin.ends_with("AVI ")) {
    return VideoContainer::avi;
  }
  if (begin.starts_with(kEbml)) {
    return VideoContainer::matroska;
  }
  for (const std::string_view type : kFirstBoxes) {
    if (begin.substr(4, 4) == type) {
      return VideoContainer::mp4;
    }
  }
  return std::nullopt;
}

/// Large AVI files are several RIFF chunks, one after the other.
bool avi_is_cut(const RangedFile& file) {
  std::uint64_t at = 0;
  while (at < file.size()) {
    const std::string head = file.read(at, 8);
    const std::uint64_t size = head.size() < 8 ? 0 : little_endian(head.substr(4));
    if (!head.starts_with("RIFF")) {
      return false;  // what stands behind the last chunk is none of the video's
    }
    if (size == 0) {
      return true;  // its writer has not come to the end
    }
    at += 8 + size + size % 2;
  }
  return at > file.size() + 1;
}

/// A box of MP4: its type, and where the next one begins; 0 for one until the end of the file.
struct Box {
  std::string type;
  std::uint64_t size = 0;
};

Box box_at(const RangedFile& file, std::uint64_t at) {
  const std::string head = file.read(at, 16);
  if (head.size() < 8) {
    return {"", 8};
  }
  const std::uint64_t size = big_endian(std::string_view(head).substr(0, 4));
  if (size == 1 && head.size() == 16) {
    return {head.substr(4, 4), big_endian(std::string_view(head).substr(8, 8))};
  }
  return {head.substr(4, 4), size};
}

bool mp4_is_cut(const RangedFile& file) {
  bool has_index = false;
  std::uint64_t at = 0;
  while (at < file.size()) {
    const Box box = box_at(file, at);
    has_index |= box.type == "moov";
    if (box.size == 0) {
      return !has_index;
    }
    if (box.size < 8 || box.size > file.size() - at) {
      return true;
    }
    at += box.size;
  }
  return !has_index;
}

/// A number of EBML: the first byte's leading zeros say how many bytes follow it.
struct EbmlNumber {
  std::uint64_t value = 0;
  std::uint64_t bytes = 0;  ///< 0 for what is none
  bool is_unknown = false;  ///< all ones: the size of what is written while it is watched
};

EbmlNumber ebml_number_at(const RangedFile& file, std::uint64_t at) {
  const std::string bytes = file.read(at, 8);
  const unsigned first = bytes.empty() ? 0 : static_cast<unsigned char>(bytes[0]);
  std::uint64_t count = 1;
  while (count <= 8 && (first & (0x100U >> count)) == 0) {
    ++count;
  }
  if (count > bytes.size()) {
    return {};
  }
  const std::uint64_t mask = (std::uint64_t{1} << (7 * count)) - 1;
  const std::uint64_t value = big_endian(std::string_view(bytes).substr(0, count)) & mask;
  return {value, count, value == mask};
}

bool matroska_is_cut(const RangedFile& file) {
  const EbmlNumber header = ebml_number_at(file, kEbml.size());
  const std::uint64_t at = kEbml.size() + header.bytes + header.value;
  if (header.bytes == 0 || file.read(at, kSegment.size()) != kSegment) {
    return true;
  }
  const EbmlNumber segment = ebml_number_at(file, at + kSegment.size());
  const std::uint64_t begin = at + kSegment.size() + segment.bytes;
  return segment.bytes == 0 ||
         (!segment.is_unknown && (begin > file.size() || segment.value > file.size() - begin));
}

}  // namespace

std::optional<VideoContainer> video_container(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) ? container_of(RangedFile(path))
                                                         : std::nullopt;
}

bool is_cut(const std::filesystem::path& path) {
  const RangedFile file(path);
  const std::optional<VideoContainer> container = container_of(file);
  if (!container) {
    return false;
  }
  switch (*container) {
    case VideoContainer::avi:
      return avi_is_cut(file);
    case VideoContainer::matroska:
      return matroska_is_cut(file);
    case VideoContainer::mp4:
      return mp4_is_cut(file);
  }
  return false;
}

}  // namespace vo
