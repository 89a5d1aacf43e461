#include "vo/dataset/camera_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/output.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

TEST(CameraFile, ReadInvertsFormat) {
  const TempFolder folder;
  for (const vo::CameraPreset& preset : vo::camera_presets()) {
    const auto path = folder.path() / (preset.name + ".toml");
    vo::write_file(path, vo::format_camera(preset.camera));
    const vo::RgbdCamera camera = vo::load_camera(path.string());
    EXPECT_EQ(vo::format_camera(camera), vo::format_camera(preset.camera));
    EXPECT_EQ(camera.pinhole.fy, preset.camera.pinhole.fy);
    EXPECT_EQ(camera.pinhole.distortion.k3, preset.camera.pinhole.distortion.k3);
    EXPECT_EQ(camera.depth_units_per_m, preset.camera.depth_units_per_m);
  }
}

TEST(CameraFile, HoldsTheDepthNoiseWhereItIsKnown) {
  const TempFolder folder;
  vo::RgbdCamera camera = vo::camera_presets().front().camera;
  EXPECT_THAT(vo::format_camera(camera), testing::Not(HasSubstr("depth_noise")));
  camera.depth_noise = {.constant = 3e-4, .quadratic = 4e-3};
  vo::write_file(folder.path() / "c.toml", vo::format_camera(camera));
  const vo::DepthNoise read = vo::read_camera(folder.path() / "c.toml").depth_noise;
  EXPECT_EQ(read.constant, 3e-4);
  EXPECT_EQ(read.linear, 0);
  EXPECT_EQ(read.quadratic, 4e-3);
}

TEST(CameraFile, HoldsAnEquirectangularCamera) {
  const TempFolder folder;
  const vo::RgbdCameraModel camera = vo::read_camera_model(
      folder.write("c.toml",
                   "projection = \"equirectangular\"\nwidth = 64\nheight = 32\n"
                   "depth_units_per_m = 1000.0\n"));
  EXPECT_EQ(camera.model.projection(), vo::CameraProjection::equirectangular);
  EXPECT_EQ(camera.model.width(), 64);
  EXPECT_EQ(camera.depth_units_per_m, 1000);
  const std::string text = vo::format_camera(camera);
  EXPECT_THAT(text, HasSubstr("projection = \"equirectangular\""));
  EXPECT_THAT(text, testing::Not(HasSubstr("fx")));
  EXPECT_EQ(vo::format_camera(vo::read_camera_model(folder.write("again.toml", text))), text);
  EXPECT_THAT(vo::format_camera(vo::camera_presets().front().camera),
              testing::Not(HasSubstr("projection")));
}

TEST(CameraFile, WhatIsTrackedOrConvertedIsAPinhole) {
  const TempFolder folder;
  const auto path = folder.path() / "camera.toml";
  vo::write_file(path, "projection = \"equirectangular\"\nwidth = 64\nheight = 32\n");
  for (const std::string& message :
       {error_text([&] { vo::read_camera(path); }),
        error_text([&] { vo::load_camera(path.string()); }),
        error_text([&] { vo::camera_of_folder(folder.path(), std::nullopt, {}); })}) {
    EXPECT_EQ(message, path.string() +
                           ": expected a pinhole camera, got projection = "
                           "\"equirectangular\"");
  }
  EXPECT_NO_THROW(vo::load_camera_model("tum-fr1"));
}

TEST(CameraFile, RefusesValuesThatAProjectionDoesNotHave) {
  const TempFolder folder;
  const auto refusal = [&](const std::string& text) {
    const auto path = folder.write("c.toml", text);
    return error_text([&] { vo::read_camera_model(path); });
  };
  const std::string panorama = "projection = \"equirectangular\"\nwidth = 64\n";
  EXPECT_THAT(refusal(panorama + "height = 32\nfx = 9.0\n"),
              EndsWith("c.toml:4: fx: expected none beside projection = \"equirectangular\", which "
                       "has width and height alone"));
  EXPECT_THAT(refusal(panorama + "height = 32\ndistortion.k1 = 0.1\n"),
              HasSubstr("c.toml:4: distortion.k1: expected none"));
  EXPECT_THAT(refusal(panorama + "height = 64\n"),
              HasSubstr("c.toml: camera: expected an equirectangular image of the whole sphere"));
  EXPECT_THAT(refusal("projection = \"cylinder\"\n"),
              AllOf(HasSubstr("c.toml:1: projection"), HasSubstr("equirectangular")));
}

TEST(CameraFile, AnUnknownPresetNamesTheNearestOne) {
  EXPECT_THAT(error_text([] { vo::load_camera("tum-fr4"); }),
              AllOf(HasSubstr("camera 'tum-fr4': neither a file nor a preset"),
                    HasSubstr("the nearest preset is tum-fr")));
}

TEST(CameraFile, ACameraThatCannotBeIsNamedWithItsFile) {
  const TempFolder folder;
  vo::write_file(folder.path() / "c.toml", "width = 640\nheight = 480\nfx = 0.0\nfy = 500.0\n");
  EXPECT_THAT(error_text([&] { vo::read_camera(folder.path() / "c.toml"); }),
              EndsWith("c.toml: camera: expected fx above 0 and fy other than 0, got 0, 500"));
  vo::write_file(folder.path() / "e.toml", "width = 640\nheight = 480\nfx = 500.0\nfy = 500.0\n");
  EXPECT_THAT(error_text([&] { vo::read_camera(folder.path() / "e.toml"); }),
              EndsWith("e.toml: camera: expected finite cx and cy, got nan, nan"));
  vo::write_file(folder.path() / "d.toml", "widht = 640\n");
  EXPECT_THAT(error_text([&] { vo::read_camera(folder.path() / "d.toml"); }),
              EndsWith("d.toml:1: unknown key 'widht'; the nearest known key is width"));
}

}  // namespace
