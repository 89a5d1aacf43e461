#include "vo/recording_files/compression.h"

#include <algorithm>
#include <limits>
#include <memory>

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr std::size_t kFirstStep = 1 << 20;  // bytes

/// What a step of decompression did.
struct Step {
  std::size_t read = 0;     ///< bytes
  std::size_t written = 0;  ///< bytes
  bool is_last = false;
};

/// Decompresses by `step(from, to, room)`, which is called until it says that it is done. The
/// result grows as bytes come, by no more than it has, and never beyond one byte more than `size`.
template <typename MakeStep>
std::string decompress_by(std::string_view bytes, std::size_t size, MakeStep step) {
  std::string result;
  std::size_t done = 0;
  for (bool is_last = false; !is_last;) {
    if (done == result.size()) {
      result.resize(std::min(size + 1, std::max(kFirstStep, 2 * result.size())));
    }
    const Step made = step(bytes, result.data() + done, result.size() - done);
    bytes.remove_prefix(made.read);
    done += made.written;
    is_last = made.is_last;
    require(done <= size, "holds more than the ", size, " bytes that were stated");
    require(is_last || made.read + made.written > 0, "ends within its compressed data");
  }
  require(done == size, "holds ", done, " bytes, expected the ", size, " that were stated");
  result.resize(done);
  return result;
}

std::string decompress_lz4(std::string_view bytes, std::size_t size) {
  LZ4F_dctx* made = nullptr;
  require(!LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)),
          "lz4: cannot be used");
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      made, LZ4F_freeDecompressionContext);
  return decompress_by(bytes, size, [&](std::string_view from, char* to, std::size_t room) {
    std::size_t written = room;
    std::size_t read = from.size();
    const std::size_t state =
        LZ4F_decompress(context.get(), to, &written, from.data(), &read, nullptr);
    require(!LZ4F_isError(state), "is damaged: lz4: ", LZ4F_getErrorName(state));
    return Step{read, written, state == 0};
  });
}

std::string decompress_zstd(std::string_view bytes, std::size_t size) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> context(ZSTD_createDStream(),
                                                                           ZSTD_freeDStream);
  require(context != nullptr, "zstd: cannot be used");
  return decompress_by(bytes, size, [&](std::string_view from, char* to, std::size_t room) {
    ZSTD_outBuffer out{to, room, 0};
    ZSTD_inBuffer in{from.data(), from.size(), 0};
    const std::size_t state = ZSTD_decompressStream(context.get(), &out, &in);
    require(ZSTD_isError(state) == 0, "is damaged: zstd: ", ZSTD_getErrorName(state));
    return Step{in.pos, out.pos, state == 0};
  });
}

/// Ends the unpacking of a stream of bzip2 with its scope.
class Bunzipper {
 public:
  Bunzipper() { require(BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK, "bzip2: cannot be used"); }
  ~Bunzipper() { BZ2_bzDecompressEnd(&stream_); }
  Bunzipper(const Bunzipper&) = delete;
  Bunzipper& operator=(const Bunzipper&) = delete;
  Bunzipper(Bunzipper&&) = delete;
  Bunzipper& operator=(Bunzipper&&) = delete;

  Step step(std::string_view from, char* to, std::size_t room) {
    constexpr std::size_t kMost = std::numeric_limits<unsigned>::max();
    const auto given = static_cast<unsigned>(std::min(kMost, from.size()));
    const auto wanted = static_cast<unsigned>(std::min(kMost, room));
    // bzip2 does not write its input, but its interface predates const.
    stream_.next_in = const_cast<char*>(from.data());
    stream_.avail_in = given;
    stream_.next_out = to;
    stream_.avail_out = wanted;
    const int status = BZ2_bzDecompress(&stream_);
    require(status == BZ_OK || status == BZ_STREAM_END, "is damaged: bzip2: error ", status);
    return {given - stream_.avail_in, wanted - stream_.avail_out, status == BZ_STREAM_END};
  }

 private:
  bz_stream stream_{};
};

std::string compress_lz4(std::string_view bytes) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.contentSize = bytes.size();
  std::string result(LZ4F_compressFrameBound(bytes.size(), &preferences), '\0');
  const std::size_t size =
      LZ4F_compressFrame(result.data(), result.size(), bytes.data(), bytes.size(), &preferences);
  require(!LZ4F_isError(size), "lz4: ", LZ4F_getErrorName(size));
  result.resize(size);
  return result;
}

std::string compress_zstd(std::string_view bytes) {
  constexpr int kLevel = 1;
  std::string result(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), kLevel);
  require(ZSTD_isError(size) == 0, "zstd: ", ZSTD_getErrorName(size));
  result.resize(size);
  return result;
}

}  // namespace

std::string decompress(Compression compression, std::string_view bytes, std::size_t size) {
  if (bytes.empty() && size == 0) {
    return {};
  }
  switch (compression) {
    case Compression::none:
      require(bytes.size() == size, "holds ", bytes.size(), " bytes, expected the ", size,
              " that were stated");
      return std::string(bytes);
    case Compression::lz4:
      return decompress_lz4(bytes, size);
    case Compression::zstd:
      return decompress_zstd(bytes, size);
    case Compression::bz2: {
      Bunzipper bunzipper;
      return decompress_by(bytes, size, [&](std::string_view from, char* to, std::size_t room) {
        return bunzipper.step(from, to, room);
      });
    }
  }
  return {};
}

std::string compress(Compression compression, std::string_view bytes) {
  switch (compression) {
    case Compression::none:
      return std::string(bytes);
    case Compression::lz4:
      return compress_lz4(bytes);
    case Compression::zstd:
      return compress_zstd(bytes);
    case Compression::bz2:
      break;
  }
  fail("bzip2 is not written, expected none, lz4 or zstd");
}

}  // namespace vo
