#include "vo/archives/gzip.h"

#include <limits>

#include <zlib.h>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr int kGzipWindow = 15 + 16;  // log2 of the largest window; + 16 asks for gzip's header

/// Ends the unpacking of a stream with its scope.
class Inflater {
 public:
  explicit Inflater(std::string_view bytes) {
    // zlib does not write its input, but its interface predates const.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    require(inflateInit2(&stream_, kGzipWindow) == Z_OK, "zlib: cannot be used");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  Inflater(Inflater&&) = delete;
  Inflater& operator=(Inflater&&) = delete;

  /// Adds at most `room` bytes to the result; returns whether they were the last ones.
  bool add_to(std::string& result, std::size_t room) {
    const std::size_t begin = result.size();
    result.resize(begin + room);
    stream_.next_out = reinterpret_cast<Bytef*>(result.data() + begin);
    stream_.avail_out = static_cast<uInt>(room);
    const int status = inflate(&stream_, Z_NO_FLUSH);
    result.resize(begin + room - stream_.avail_out);
    require(status == Z_OK || status == Z_STREAM_END, "the .gz file is damaged or cut");
    return status == Z_STREAM_END;
  }

 private:
  z_stream stream_{};
};

}  // namespace

std::string gzip(std::string_view bytes) {
  constexpr int kMemory = 9;
  z_stream stream{};
  require(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemory,
                       Z_DEFAULT_STRATEGY) == Z_OK,
          "zlib: cannot be used");
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  // zlib does not write its input, but its interface predates const.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  require(status == Z_STREAM_END, "zlib: cannot compress ", bytes.size(), " bytes");
  return result;
}

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

std::string gunzip(std::string_view bytes, std::size_t max_bytes) {
  constexpr std::size_t kStep = 1'000'000;  // bytes
  require(bytes.size() <= std::numeric_limits<uInt>::max(), "the .gz file has ", bytes.size(),
          " bytes, expected less than 4 GB");
  Inflater inflater(bytes);
  std::string result;
  for (bool is_complete = false; !is_complete;) {
    is_complete = inflater.add_to(result, kStep);
    require(result.size() <= max_bytes, "the .gz file holds more than ", max_bytes, " bytes");
  }
  return result;
}

}  // namespace vo
