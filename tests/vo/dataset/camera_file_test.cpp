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
