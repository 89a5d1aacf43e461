#include "vo/archives/zip.h"

#include <array>
#include <cstdint>
#include <limits>

#include "vo/archives/crc32.h"
#include "vo/core/error.h"

namespace vo {
namespace {

// The records of an archive and their fields, as PKWARE's APPNOTE.TXT numbers them (4.3).
constexpr std::uint32_t kLocalHeader = 0x04034b50;
constexpr std::uint32_t kCentralHeader = 0x02014b50;
constexpr std::uint32_t kEndRecord = 0x06054b50;
constexpr std::uint16_t kVersion = 20;         // 2.0, the first with folders in names
constexpr std::uint16_t kUtf8Names = 1 << 11;  // flag of a file
constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kMidnight = 0;
constexpr std::uint16_t kFirstDay = 1 << 5 | 1;  // 1 January 1980, the earliest there is

void append16(std::string& bytes, std::uint16_t value) {
  bytes.push_back(static_cast<char>(value & 0xff));
  bytes.push_back(static_cast<char>(value >> 8));
}

void append32(std::string& bytes, std::uint32_t value) {
  append16(bytes, static_cast<std::uint16_t>(value & 0xffff));
  append16(bytes, static_cast<std::uint16_t>(value >> 16));
}

/// Appends what the headers of a file share: from the version that is needed to the name's length.
void append_description(std::string& bytes, const NamedBytes& file) {
  const std::uint32_t checksum = crc32_of(file.bytes);
  const auto size = static_cast<std::uint32_t>(file.bytes.size());
  for (const std::uint16_t value : {kVersion, kUtf8Names, kStored, kMidnight, kFirstDay}) {
    append16(bytes, value);
  }
  append32(bytes, checksum);
  append32(bytes, size);  // compressed
  append32(bytes, size);
  append16(bytes, static_cast<std::uint16_t>(file.name.size()));
  append16(bytes, 0);  // length of what else is told
}

std::string central_header(const NamedBytes& file, std::uint32_t begin) {
  std::string bytes;
  append32(bytes, kCentralHeader);
  append16(bytes, kVersion);
  append_description(bytes, file);
  append16(bytes, 0);  // length of a comment
  append16(bytes, 0);  // number of the disk
  append16(bytes, 0);  // whether it is text
  append32(bytes, 0);  // attributes
  append32(bytes, begin);
  return bytes + file.name;
}

std::string end_record(std::size_t files, std::size_t begin, std::size_t size) {
  std::string bytes;
  append32(bytes, kEndRecord);
  append32(bytes, 0);  // numbers of disks
  append16(bytes, static_cast<std::uint16_t>(files));
  append16(bytes, static_cast<std::uint16_t>(files));
  append32(bytes, static_cast<std::uint32_t>(size));
  append32(bytes, static_cast<std::uint32_t>(begin));
  append16(bytes, 0);  // length of a comment
  return bytes;
}

}  // namespace

std::string zip(const std::vector<NamedBytes>& files) {
  std::size_t total = 0;
  for (const NamedBytes& file : files) {
    require(file.name.size() < std::numeric_limits<std::uint16_t>::max(),
            "an archive cannot hold a name of ", file.name.size(), " bytes");
    total += file.bytes.size() + 2 * file.name.size() + 100;  // with both headers
  }
  require(files.size() < std::numeric_limits<std::uint16_t>::max() &&
              total < std::numeric_limits<std::uint32_t>::max(),
          "an archive cannot hold ", files.size(), " files of ", total, " bytes");
  std::string bytes;
  std::string directory;
  for (const NamedBytes& file : files) {
    directory += central_header(file, static_cast<std::uint32_t>(bytes.size()));
    append32(bytes, kLocalHeader);
    append_description(bytes, file);
    bytes += file.name + file.bytes;
  }
  return bytes + directory + end_record(files.size(), bytes.size(), directory.size());
}

}  // namespace vo
