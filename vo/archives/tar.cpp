#include "vo/archives/tar.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr std::size_t kBlock = 512;                    // bytes, of which an archive is made
constexpr std::size_t kNameBytes = 100;                // length of the field `name`
constexpr std::size_t kSizeDigits = 11;                // length of the field `size` without its end
constexpr std::uintmax_t kLeastTooLarge = 1ULL << 33;  // bytes, 8^kSizeDigits
constexpr std::size_t kChecksumAt = 148;               // offset of the field `chksum`
constexpr std::size_t kChecksumDigits = 6;

/// Returns a number in octal digits, with zeros in front.
std::string octal(std::uintmax_t number, std::size_t digits) {
  constexpr std::uintmax_t kBase = 8;
  std::string text(digits, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number /= kBase) {
    *digit = static_cast<char>('0' + number % kBase);
  }
  return text;
}

/// A field of an entry's header: where it begins, and its text.
struct HeaderField {
  std::size_t offset;
  std::string text;
};

/// Returns the header of a regular file.
std::string header_of(const NamedBytes& file) {
  std::string header(kBlock, '\0');
  const auto put = [&](const HeaderField& field) {
    std::copy(field.text.begin(), field.text.end(),
              header.begin() + static_cast<std::ptrdiff_t>(field.offset));
  };
  put({0, file.name});
  put({100, "0000644"});  // mode
  put({108, "0000000"});  // uid
  put({116, "0000000"});  // gid
  put({124, octal(file.bytes.size(), kSizeDigits)});
  put({136, octal(0, kSizeDigits)});                          // mtime
  put({kChecksumAt, std::string(kChecksumDigits + 2, ' ')});  // counts as blanks
  put({156, "0"});                                            // typeflag: a regular file
  put({257, "ustar"});                                        // magic
  put({263, "00"});                                           // version
  const auto sum = std::accumulate(
      header.begin(), header.end(), std::uintmax_t{0},
      [](std::uintmax_t before, char c) { return before + static_cast<unsigned char>(c); });
  put({kChecksumAt, octal(sum, kChecksumDigits) + std::string("\0 ", 2)});
  return header;
}

}  // namespace

std::string tar_entry(const NamedBytes& file) {
  require(!file.name.empty() && file.name.size() <= kNameBytes, "tar: ", file.name,
          ": expected a name of 1 to ", kNameBytes, " bytes");
  require(file.bytes.size() < kLeastTooLarge, "tar: ", file.name, ": ", file.bytes.size(),
          " bytes, expected less than 8 GiB");
  std::string entry = header_of(file) + file.bytes;
  entry.resize((entry.size() + kBlock - 1) / kBlock * kBlock, '\0');
  return entry;
}

std::string tar_end() {
  return std::string(2 * kBlock, '\0');
}

}  // namespace vo
