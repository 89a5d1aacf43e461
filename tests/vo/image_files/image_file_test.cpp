#include "vo/image_files/image_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/image_files/jpeg_codec.h"
#include "vo/image_files/png.h"
#include "vo/image_files/pnm.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

/// A JPEG that cjpeg would call grey, 16 x 8 px, of 40 + 8 u + 4 v, made by libjpeg-turbo.
constexpr const char* kGreyJpeg =
    "ffd8ffe000104a46494600010100000100010000ffdb00430002010101010102010101020202020204030202020205"
    "04"
    "040304060506060605060606070908060709070606080b08090a0a0a0a0a06080b0c0b0a0c090a0a0affc0000b0800"
    "08"
    "001001011100ffc4001f0000010501010101010100000000000000000102030405060708090a0bffc400b510000201"
    "03"
    "03020403050504040000017d01020300041105122131410613516107227114328191a1082342b1c11552d1f0243362"
    "72"
    "82090a161718191a25262728292a3435363738393a434445464748494a535455565758595a636465666768696a7374"
    "75"
    "767778797a838485868788898a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5c6c7c8"
    "c9"
    "cad2d3d4d5d6d7d8d9dae1e2e3e4e5e6e7e8e9eaf1f2f3f4f5f6f7f8f9faffda0008010100003f00f91ff66df86dff"
    "00"
    "1eff00e8fe9dabf403f66df86dff001eff00e8fe9dabffd9";

std::string bytes_of_hex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// Colours that change slowly, which a JPEG keeps well.
vo::ColorImage gradient() {
  vo::ColorImage image(24, 32);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image(v, u) = {static_cast<uchar>(4 * u), static_cast<uchar>(6 * v),
                     static_cast<uchar>(200 - 3 * u)};
    }
  }
  return image;
}

class ImageFile : public testing::Test {
 protected:
  cv::Mat read(const std::string& bytes) { return vo::read_image(folder.write("image", bytes)); }

  std::string error_of(const std::string& bytes) {
    return error_text([&] { read(bytes); });
  }

  TempFolder folder;
};

TEST_F(ImageFile, IsRecognisedByItsFirstBytes) {
  const vo::ColorImage image = gradient();
  EXPECT_EQ(cv::norm(read(vo::encode_png(image)), image, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(read(vo::encode_pnm(image)), image, cv::NORM_INF), 0);
  const auto jpeg = vo::encode_jpeg(image, 100, vo::ChromaSampling::full);
  const cv::Mat copy = read({jpeg.begin(), jpeg.end()});
  ASSERT_EQ(copy.type(), CV_8UC3);
  EXPECT_LE(cv::norm(copy, image, cv::NORM_INF), 4) << "grey values, and blue is still blue";
}

TEST_F(ImageFile, AGreyJpegIsGrey) {
  const cv::Mat image = read(bytes_of_hex(kGreyJpeg));
  ASSERT_EQ(image.type(), CV_8UC1);
  ASSERT_EQ(image.size(), cv::Size(16, 8));
  for (int i = 0; i < 128; ++i) {
    EXPECT_NEAR(image.at<uchar>(i / 16, i % 16), 40 + 8 * (i % 16) + 4 * (i / 16), 3);
  }
}

TEST_F(ImageFile, GreyMapsHaveEightOrSixteenBits) {
  const cv::Mat_<uchar> bytes = (cv::Mat_<uchar>(2, 3) << 0, 1, 2, 128, 254, 255);
  EXPECT_EQ(cv::norm(read(vo::encode_pnm(bytes)), bytes, cv::NORM_INF), 0);
  const cv::Mat_<std::uint16_t> wide =
      (cv::Mat_<std::uint16_t>(2, 3) << 0, 1, 256, 513, 65534, 65535);
  const cv::Mat copy = read(vo::encode_pnm(wide));
  ASSERT_EQ(copy.type(), CV_16UC1);
  EXPECT_EQ(cv::norm(copy, wide, cv::NORM_INF), 0);
}

/// Netpbm's description of PGM and PPM has comments in the header, the high byte first and red
/// first.
TEST_F(ImageFile, PortableMapsAreReadAsTheirFormatHasThem) {
  const cv::Mat grey = read("P5 # made by hand\n2 1\n# a line\n15\n" + std::string("\x0f\x03"));
  EXPECT_EQ(grey.at<uchar>(0, 0), 255);
  EXPECT_EQ(grey.at<uchar>(0, 1), 51) << "values are scaled";
  const cv::Mat wide = read("P5\n1 1\n65535\n" + std::string("\x01\x02"));
  EXPECT_EQ(wide.at<std::uint16_t>(0, 0), 0x0102);
  const cv::Mat color = read("P6\n1 1\n255\n" + std::string("\x01\x02\x03"));
  EXPECT_EQ(color.at<cv::Vec3b>(0, 0), cv::Vec3b(3, 2, 1)) << "blue, green, red";
}

TEST_F(ImageFile, ErrorsNameTheFileAndWhatIsWrong) {
  EXPECT_THAT(error_of("BM"), HasSubstr("image: is no image that is read, expected PNG, JPEG"));
  EXPECT_THAT(error_of(""), HasSubstr("is no image that is read"));
  const auto jpeg = vo::encode_jpeg(gradient(), 90, vo::ChromaSampling::quarter);
  const std::string bytes(jpeg.begin(), jpeg.end());
  EXPECT_THAT(error_of(bytes.substr(0, bytes.size() - 40)),
              HasSubstr("image: cannot be decoded: it is truncated"));
  EXPECT_THAT(error_of(bytes.substr(0, 30)), HasSubstr("image: cannot be decoded: "));
  EXPECT_THAT(error_of("P5\n4 4\n255\n12"), HasSubstr("expected 27 bytes for 4x4 px, got 13"));
  EXPECT_THAT(error_of("P5\n99999 4\n255\n12"), HasSubstr("image: expected 4"));
  EXPECT_THAT(error_of("P6\n4 4\n65535\n"), HasSubstr("expected a greatest value from 1 to 255"));
  EXPECT_THAT(error_of("P5\n4 x\n255\n"), HasSubstr("expected width, height and greatest value"));
  EXPECT_THAT(error_of("P5\n0 4\n255\n"), HasSubstr("image: expected an image of 1 to 16384 px"));
}

/// A header that promises 16384 x 16384 px must not be believed in a file of some hundred bytes.
TEST_F(ImageFile, AJpegsSizeIsHeldToTheFile) {
  const auto jpeg = vo::encode_jpeg(gradient(), 90, vo::ChromaSampling::full);
  std::string bytes(jpeg.begin(), jpeg.end());
  const std::size_t frame = bytes.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  bytes.replace(frame + 5, 4, std::string("\x40\x00\x40\x00", 4));
  EXPECT_THAT(error_of(bytes), HasSubstr("too few for 16384x16384 px"));
}

}  // namespace
