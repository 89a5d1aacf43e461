#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace vo {

/// How a part of a recording is compressed.
enum class Compression { none, lz4, zstd, bz2 };

constexpr auto enum_names(Compression) {
  return std::array{std::pair{Compression::none, "none"}, std::pair{Compression::lz4, "lz4"},
                    std::pair{Compression::zstd, "zstd"}, std::pair{Compression::bz2, "bz2"}};
}

/// Returns the `size` bytes that were compressed: to a frame of LZ4 or zstd or a stream of bzip2.
/// Memory is asked for as they come, not as `size` states. Throws Error if they are damaged, or
/// fewer or more than `size`.
std::string decompress(Compression compression, std::string_view bytes, std::size_t size);

/// Returns a frame of LZ4 or zstd, or the bytes as they are. Throws Error for bzip2.
std::string compress(Compression compression, std::string_view bytes);

}  // namespace vo
