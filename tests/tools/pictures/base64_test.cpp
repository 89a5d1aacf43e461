#include "tools/pictures/base64.h"

#include <gtest/gtest.h>

namespace {

TEST(Base64, GivesTheTestVectorsOfRfc4648) {
  EXPECT_EQ(tools::base64(""), "");
  EXPECT_EQ(tools::base64("f"), "Zg==");
  EXPECT_EQ(tools::base64("fo"), "Zm8=");
  EXPECT_EQ(tools::base64("foo"), "Zm9v");
  EXPECT_EQ(tools::base64("foob"), "Zm9vYg==");
  EXPECT_EQ(tools::base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(tools::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(tools::base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
