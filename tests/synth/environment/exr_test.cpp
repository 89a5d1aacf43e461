#include "synth/environment/exr.h"

#include <limits>
#include <string>

#include <ImfStandardAttributes.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/environment/environment.h"
#include "tests/support/error_text.h"
#include "tests/support/exr_file.h"
#include "tests/support/same_pixels.h"
#include "tests/support/temp_folder.h"

namespace synth {
namespace {

namespace fs = std::filesystem;

using support::error_text;
using testing::HasSubstr;

/// Returns light that half precision holds: 10 bits a channel at most.
cv::Mat_<cv::Vec3f> picture(cv::Size size) {
  cv::Mat_<cv::Vec3f> image(size);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      image(v, u) = {static_cast<float>(u) / 8, static_cast<float>(v) * 4,
                     static_cast<float>(u + v) / 1024};
    }
  }
  return image;
}

std::string encoded(const cv::Mat_<cv::Vec3f>& image) {
  return support::encode_exr(image, Imf::ZIP_COMPRESSION, Imf::FLOAT);
}

class Exr : public testing::Test {
 protected:
  void write(const std::string& bytes) const { folder_.write("light.exr", bytes); }

  void expect_read(const cv::Mat_<cv::Vec3f>& image) const {
    EXPECT_TRUE(support::have_same_pixels(read_exr(path()), image));
  }

  std::string error() const {
    return error_text([&] { read_exr(path()); });
  }

  fs::path path() const { return folder_.path() / "light.exr"; }

  const cv::Mat_<cv::Vec3f> image_ = picture({40, 20});
  support::TempFolder folder_;
};

TEST_F(Exr, EveryLosslessCompressionGivesTheSamePixels) {
  for (const Imf::Compression compression :
       {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
        Imf::PIZ_COMPRESSION}) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
      write(support::encode_exr(image_, compression, type));
      expect_read(image_);
    }
  }
}

TEST_F(Exr, LossyCompressionsGiveWhatOpenExrsReaderInCppFinds) {
  for (const Imf::Compression compression :
       {Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION}) {
    write(support::encode_exr(image_, compression, Imf::HALF));
    expect_read(support::decode_exr(path()));
  }
}

TEST_F(Exr, CompressionByDwaIsRefusedByName) {
  for (const Imf::Compression compression : {Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
    write(support::encode_exr(image_, compression, Imf::HALF));
    EXPECT_THAT(error(), HasSubstr("light.exr: is compressed by DWA"));
  }
}

TEST_F(Exr, TilesAndAWindowElsewhereGiveTheSamePixels) {
  Imf::Header header(image_.cols, image_.rows);
  header.setTileDescription(Imf::TileDescription(16, 8));
  write(support::encode_exr<Imf::TiledOutputFile>(image_, header, Imf::FLOAT));
  expect_read(image_);
  const Imath::Box2i window({-7, 5}, {-7 + image_.cols - 1, 5 + image_.rows - 1});
  write(support::encode_exr(image_, Imf::Header(window, window), Imf::HALF));
  expect_read(image_);
}

TEST_F(Exr, OtherChannelsAreLeftOut) {
  for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
    write(support::encode_exr(image_, {image_.cols, image_.rows}, type,
                              {"R", "G", "B", "A", "Y", "Z"}));
    expect_read(image_);
  }
}

TEST_F(Exr, OneChannelOfBrightnessIsGrey) {
  write(support::encode_exr(image_, {image_.cols, image_.rows}, Imf::FLOAT, {"Y"}));
  cv::Mat_<cv::Vec3f> grey = image_.clone();
  for (cv::Vec3f& light : grey) {
    light = {light[0], light[0], light[0]};
  }
  expect_read(grey);
}

TEST_F(Exr, NegativeLightIsNone) {
  cv::Mat_<cv::Vec3f> image = image_.clone();
  image(3, 4)[1] = -0.01F;
  write(encoded(image));
  image(3, 4)[1] = 0;
  expect_read(image);
}

TEST_F(Exr, IsAnEnvironmentAsRadiancesImageIs) {
  write(encoded(image_));
  const Environment environment = read_environment(path().string());
  EXPECT_TRUE(support::have_same_pixels(environment.radiance, image_));
  write(encoded(picture({20, 20})));
  EXPECT_THAT(error_text([&] { read_environment(path().string()); }),
              HasSubstr("light.exr: is 20 x 20 px, expected an equirectangular image"));
}

TEST_F(Exr, WhatIsNoLightIsRefusedWithItsPixel) {
  cv::Mat_<cv::Vec3f> image = image_.clone();
  image(3, 4)[1] = std::numeric_limits<float>::quiet_NaN();
  write(encoded(image));
  EXPECT_THAT(error(), HasSubstr("light.exr: pixel 4, 3 is nan, expected finite numbers"));
}

TEST_F(Exr, OtherImagesAreRefusedByName) {
  write(support::encode_exr(image_, {image_.cols, image_.rows}, Imf::FLOAT, {"X", "Z"}));
  EXPECT_THAT(error(), HasSubstr("light.exr: has the channels X, Z, expected R, G and B, or Y"));
  Imf::Header header(image_.cols, image_.rows);
  Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
  write(support::encode_exr(image_, header, Imf::FLOAT));
  EXPECT_THAT(error(), HasSubstr("is a cube map, expected an equirectangular image"));
}

TEST_F(Exr, DamageIsNamed) {
  const std::string bytes = encoded(image_);
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{3}, std::size_t{60}, bytes.size() / 2, bytes.size() - 1}) {
    write(bytes.substr(0, length));
    EXPECT_THAT(error(),
                HasSubstr("light.exr: expected an image of linear light in OpenEXR's format"))
        << length;
  }
  write("#?RADIANCE\n");
  EXPECT_THAT(error(), HasSubstr("light.exr: expected an image of linear light"));
}

}  // namespace
}  // namespace synth
