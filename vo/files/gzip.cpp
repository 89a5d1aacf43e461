#include "vo/files/gzip.h"

#include <zlib.h>

#include "vo/core/error.h"

namespace vo {

std::string gzip(std::string_view bytes) {
  constexpr int kGzipWindow = 15 + 16;  // log2 of the largest window; + 16 asks for gzip's header
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

}  // namespace vo
