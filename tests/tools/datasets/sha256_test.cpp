#include "tools/datasets/sha256.h"

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace {

/// The examples of FIPS 180-4's publisher, NIST's "Secure Hash Standard: example values".
TEST(Sha256, HashesAsThePublishedExamples) {
  EXPECT_EQ(tools::sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(tools::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, HashesFilesAsTheirBytes) {
  const support::TempFolder folder;
  for (const std::size_t size : {0U, 5U, 1U << 20, (1U << 20) + 1, 3U << 20}) {
    const std::string bytes(size, 'x');
    EXPECT_EQ(tools::sha256_of_file(folder.write("file", bytes)), tools::sha256(bytes)) << size;
  }
}

}  // namespace
