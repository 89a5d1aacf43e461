#include "tools/datasets/sha256.h"

#include <array>
#include <cstdint>
#include <memory>

#include <openssl/evp.h>

#include "vo/core/error.h"
#include "vo/files/ranged_file.h"

namespace tools {
namespace {

struct FreeDigest {
  void operator()(EVP_MD_CTX* digest) const { EVP_MD_CTX_free(digest); }
};

/// A SHA-256 of bytes that are added one after another.
class Sha256 {
 public:
  Sha256() : digest_(EVP_MD_CTX_new()) {
    vo::require(digest_ != nullptr && EVP_DigestInit_ex(digest_.get(), EVP_sha256(), nullptr) == 1,
                "SHA-256: libcrypto has none");
  }

  void add(std::string_view bytes) {
    vo::require(EVP_DigestUpdate(digest_.get(), bytes.data(), bytes.size()) == 1,
                "SHA-256: libcrypto failed");
  }

  std::string hex() {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int size = 0;
    vo::require(EVP_DigestFinal_ex(digest_.get(), bytes.data(), &size) == 1,
                "SHA-256: libcrypto failed");
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += kDigits[bytes[i] >> 4];
      text += kDigits[bytes[i] & 0xf];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, FreeDigest> digest_;
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Sha256 digest;
  digest.add(bytes);
  return digest.hex();
}

std::string sha256_of_file(const std::filesystem::path& file) {
  constexpr std::uintmax_t kPiece = 1 << 20;  // bytes
  const vo::RangedFile bytes(file);
  Sha256 digest;
  for (std::uintmax_t offset = 0; offset < bytes.size(); offset += kPiece) {
    const std::string piece = bytes.read(offset, kPiece);
    digest.add(piece);
    if (piece.size() < kPiece) {
      break;
    }
  }
  return digest.hex();
}

}  // namespace tools
