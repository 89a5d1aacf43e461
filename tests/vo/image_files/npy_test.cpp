#include "vo/image_files/npy.h"

#include <array>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/output.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

TEST(Npy, ReadInvertsEncode) {
  const TempFolder folder;
  cv::Mat_<float> image(3, 5);
  for (int i = 0; i < 15; ++i) {
    image(i / 5, i % 5) = 0.1F * static_cast<float>(i) - 0.3F;
  }
  image(1, 1) = std::numeric_limits<float>::denorm_min();
  vo::write_file(folder.path() / "a.npy", vo::encode_npy(image));
  const cv::Mat_<float> copy = vo::read_npy(folder.path() / "a.npy");
  ASSERT_EQ(copy.size(), image.size());
  EXPECT_TRUE(std::equal(image.begin(), image.end(), copy.begin()));
}

/// The header as NumPy's format description (version 1.0) has it.
TEST(Npy, HeaderIsPaddedTo64Bytes) {
  const std::string bytes = vo::encode_npy(cv::Mat_<float>(2, 3, 1.0F));
  ASSERT_EQ(bytes.size(), 128 + 2 * 3 * sizeof(float));
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_EQ(bytes[127], '\n');
  EXPECT_THAT(bytes, HasSubstr("'descr': '<f4', 'fortran_order': False, 'shape': (2, 3)"));
}

TEST(Npy, NumbersHaveTheShapeThatIsAskedFor) {
  const std::array<double, 3> values = {1, 2.5, -3};
  const std::string list = vo::encode_npy(values, std::array<std::size_t, 1>{3});
  ASSERT_EQ(list.size(), 128 + sizeof(values));
  EXPECT_THAT(list, HasSubstr("'descr': '<f8', 'fortran_order': False, 'shape': (3, ), }"));
  EXPECT_EQ(std::memcmp(list.data() + 128, values.data(), sizeof(values)), 0);
  EXPECT_THAT(vo::encode_npy(values, std::array<std::size_t, 2>{1, 3}), HasSubstr("(1, 3, )"));
}

TEST(Npy, RejectsOtherFiles) {
  const TempFolder folder;
  const std::string bytes = vo::encode_npy(cv::Mat_<float>(2, 3, 1.0F));
  vo::write_file(folder.path() / "cut.npy", bytes.substr(0, bytes.size() - 1));
  EXPECT_THAT(error_text([&] { vo::read_npy(folder.path() / "cut.npy"); }),
              HasSubstr("cut.npy: expected 152 bytes for 3x2 px, got 151"));
  vo::write_file(folder.path() / "text.npy", "no array");
  EXPECT_THAT(error_text([&] { vo::read_npy(folder.path() / "text.npy"); }),
              HasSubstr("text.npy: expected a version 1.0 .npy file"));
}

}  // namespace
