#include "vo/rigs/rig_file.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/core/fields.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

constexpr const char* kImage =
    "width = 64\nheight = 48\nfx = 50.0\nfy = 51.0\ncx = 31.5\ncy = 23.5\n";

std::string camera(const std::string& name, const std::string& rest = "") {
  return "[[camera]]\nname = \"" + name + "\"\n" + kImage + rest + "\n";
}

vo::Rig read(const std::string& text) {
  const TempFolder folder;
  return vo::read_rig(folder.write("rig.toml", text));
}

std::string refusal(const std::string& text) {
  return error_text([&] { read(text); });
}

/// Returns the greatest difference of two poses' matrices.
double difference(const vo::SE3& a, const vo::SE3& b) {
  return std::max((a.rotation_matrix() - b.rotation_matrix()).cwiseAbs().maxCoeff(),
                  (a.translation() - b.translation()).cwiseAbs().maxCoeff());
}

TEST(RigFile, MatrixAndQuaternionAreOnePose) {
  const vo::Rig rig = read(
      camera("a", "T_body_camera = [[0, 0, 1, 0.5], [-1, 0, 0, -2], [0, -1, 0, 3], [0, 0, 0, 1]]") +
      camera("b", "position = [0.5, -2, 3]\norientation = [-0.5, 0.5, -0.5, 0.5]"));
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_LT(difference(rig.cameras[0].T_body_camera, rig.cameras[1].T_body_camera), 1e-15);
  // The camera's z axis, forward, is the body's x.
  EXPECT_LT((rig.cameras[0].T_body_camera.rotation() * Eigen::Vector3d::UnitZ() -
             Eigen::Vector3d::UnitX())
                .norm(),
            1e-15);
}

TEST(RigFile, ReadsWhatIsWrittenOfARig) {
  const vo::Rig rig =
      read("[imu]\nposition = [0.1, 0.2, 0.3]\norientation = [0, 0.6, 0, 0.8]\n" +
           camera("left",
                  "stereo = \"right\"\ntime_offset = 0.002\nsensor.preset = \"kinect-v1\"\n"
                  "sensor.depth.offset = [0.025, 0, 0]\nposition = [0, 0, 1e-3]") +
           camera("right", "time_offset = 0.002\nposition = [0.1, 0, 1e-3]") +
           camera("fish", "distortion.model = \"kannala_brandt\"\ndistortion.k1 = -0.013"));
  const vo::Rig again = read(vo::format_rig(rig));
  EXPECT_LT(difference(again.T_body_imu, rig.T_body_imu), 1e-15);
  ASSERT_EQ(again.cameras.size(), 3U);
  for (std::size_t i = 0; i < again.cameras.size(); ++i) {
    vo::RigCamera a = rig.cameras[i];
    vo::RigCamera b = again.cameras[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.stereo, b.stereo);
    EXPECT_EQ(a.time_offset, b.time_offset);
    EXPECT_LT(difference(a.T_body_camera, b.T_body_camera), 1e-15);
    const std::vector<vo::Field> before = vo::fields_of(a.camera);
    const std::vector<vo::Field> after = vo::fields_of(b.camera);
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_EQ(before[k].get(), after[k].get()) << before[k].key;
    }
    ASSERT_EQ(a.sensor.size(), b.sensor.size());
    for (std::size_t k = 0; k < a.sensor.size(); ++k) {
      EXPECT_EQ(a.sensor[k].key + a.sensor[k].text, b.sensor[k].key + b.sensor[k].text);
    }
  }
  EXPECT_EQ(vo::format_rig(again), vo::format_rig(read(vo::format_rig(again))));
}

constexpr const char* kFov = "fov_deg = [80, 50.5]\n";

std::string projector(const std::string& name, const std::string& rest = kFov) {
  return "[[projector]]\nname = \"" + name + "\"\n" + rest + "\n";
}

TEST(RigFile, ReadsProjectorsAndTheLightThatCamerasSee) {
  const TempFolder folder;
  const vo::Rig rig = vo::read_rig(folder.write(
      "rig.toml",
      projector("a", std::string(kFov) +
                         "position = [0.1, 0, 0]\norientation = [0, 0.6, 0, 0.8]\npower = 7\n"
                         "dots.number = 9\ndots.diameter_deg = 0.5\ndots.seed = 3") +
          camera("color") + camera("left", "spectrum = \"infrared\"\nscene_light = 0.25") +
          projector("b", std::string(kFov) + "pattern = \"patterns/b.png\"") + camera("rest")));
  EXPECT_EQ(rig.cameras[0].spectrum, vo::Spectrum::visible);
  EXPECT_EQ(rig.cameras[1].spectrum, vo::Spectrum::infrared);
  EXPECT_EQ(rig.cameras[1].scene_light, 0.25);
  EXPECT_EQ(rig.cameras.size(), 3U);
  ASSERT_EQ(rig.projectors.size(), 2U);
  const vo::RigProjector& dots = rig.projectors[0];
  EXPECT_LT(difference(dots.T_body_projector, {{0.8, 0, 0.6, 0}, {0.1, 0, 0}}), 1e-15);
  EXPECT_EQ(dots.fov_deg, Eigen::Vector2d(80, 50.5));
  EXPECT_EQ(dots.power, 7);
  EXPECT_EQ(dots.dots.number, 9);
  EXPECT_EQ(dots.dots.diameter_deg, 0.5);
  EXPECT_EQ(dots.dots.seed, 3U);
  EXPECT_FALSE(dots.has_file());
  EXPECT_EQ(rig.projectors[1].power, 1);
  EXPECT_EQ(rig.projectors[1].file(), folder.path() / "patterns/b.png");
  EXPECT_EQ(vo::format_rig(read(vo::format_rig(rig))), vo::format_rig(rig));
}

TEST(RigFile, RefusesProjectorsThatAreNone) {
  const auto refused = [](const std::string& rest) {
    return refusal(camera("a") + projector("p", rest));
  };
  const std::string fov = kFov;
  EXPECT_THAT(refusal(camera("a") + projector("p") + projector("p")),
              HasSubstr("rig.toml:14: projector 'p': expected a name of its own"));
  EXPECT_THAT(refusal(camera("a") + projector("../p")), HasSubstr("expected a name of letters"));
  EXPECT_THAT(refusal(camera("a") + "[[projector]]\n" + fov), HasSubstr(":10: [[projector]]: "));
  EXPECT_THAT(refused(""), HasSubstr("rig.toml:10: projector 'p': expected fov_deg"));
  EXPECT_THAT(refused("fov_deg = [80]"), HasSubstr("rig.toml:12: fov_deg"));
  EXPECT_THAT(refused("fov_deg = [80, 0]"), HasSubstr("'p': fov_deg: expected two angles"));
  EXPECT_THAT(refused("fov_deg = [180, 60]"), HasSubstr("from 1 to 170 deg, got 180"));
  EXPECT_THAT(refused("fov_deg = [nan, 60]"), HasSubstr("fov_deg"));
  EXPECT_THAT(refused(fov + "power = -1.0"), HasSubstr("'p': power: expected"));
  EXPECT_THAT(refused(fov + "power = inf"), HasSubstr("power"));
  EXPECT_THAT(refused(fov + "power = 1e300"),
              HasSubstr("'p': power: expected a radiant intensity from 0 to 1e+09, got 1e+300"));
  EXPECT_THAT(refused(fov + "pattern = \"stripes\""),
              HasSubstr("'p': pattern: is \"stripes\", expected \"random_dots\" or a PNG file"));
  EXPECT_THAT(refused(fov + "pattern = \"p.png\"\ndots.seed = 1"), HasSubstr("'p': dots: "));
  EXPECT_THAT(refused(fov + "dots.number = 0"), HasSubstr("'p': dots.number: expected"));
  EXPECT_THAT(refused(fov + "dots.diameter_deg = 0.0"), HasSubstr("'p': dots.diameter_deg"));
  EXPECT_THAT(refused(fov + "brightness = 2"), HasSubstr("rig.toml:13: "));
  EXPECT_THAT(refused(fov + "orientation = [0, 0, 0, 2]"), HasSubstr("projector 'p': expected a"));
  EXPECT_THAT(refusal(camera("a", "spectrum = \"ultraviolet\"")), HasSubstr("infrared"));
  EXPECT_THAT(refusal(camera("a", "scene_light = 0.5")), HasSubstr("'a': scene_light: is for"));
  EXPECT_THAT(refusal(camera("a", "spectrum = \"infrared\"\nscene_light = 1.5")),
              HasSubstr("'a': scene_light: expected a share from 0 to 1, got 1.5"));
}

TEST(RigFile, HasAtMostSixteenProjectors) {
  std::string text = camera("a");
  for (int i = 0; i < 16; ++i) {
    text += projector(vo::concat("p", i));
  }
  EXPECT_EQ(read(text).projectors.size(), 16U);
  EXPECT_THAT(refusal(text + projector("q")),
              HasSubstr("rig.toml:74: [[projector]]: expected at most 16 projectors, got 17"));
}

TEST(RigFile, TheBaselineIsTheDistanceOfARectifiedPairHoweverItIsTurned) {
  const std::string turned = "\norientation = [0, 0, 0.6, 0.8]";  // x is (0.28, 0.96, 0)
  const vo::Rig rig = read(camera("l", "stereo = \"r\"\nposition = [1, 2, 3]" + turned) +
                           camera("r", "position = [1.028, 2.096, 3]" + turned));
  EXPECT_NEAR(vo::stereo_baseline(rig, rig.cameras[0]), 0.1, 1e-12);
}

TEST(RigFile, RefusesNamesThatAreNotFoldersOfTheirOwn) {
  EXPECT_THAT(refusal(camera("a") + camera("a")),
              HasSubstr("rig.toml:10: camera 'a': expected a name of its own"));
  EXPECT_THAT(refusal(camera("../a")), HasSubstr("camera '../a': expected a name of letters"));
  EXPECT_THAT(refusal(camera("truth")), HasSubstr("other than truth"));
  EXPECT_THAT(refusal(std::string("[[camera]]\n") + kImage), HasSubstr(":1: [[camera]]: expected"));
  EXPECT_THAT(refusal(""), HasSubstr("expected a table [[camera]] for each camera"));
  EXPECT_THAT(refusal("camera = 3"), HasSubstr("expected tables [[camera]]"));
}

TEST(RigFile, RefusesKeysAndValuesThatItDoesNotKnow) {
  EXPECT_THAT(refusal(camera("a", "focal = 3.0")), HasSubstr("rig.toml:9: "));
  EXPECT_THAT(refusal(camera("a", "T_body_cam = [0]")), HasSubstr("T_body_camera"));
  EXPECT_THAT(refusal("body = 1\n" + camera("a")), HasSubstr("rig.toml:1: "));
  EXPECT_THAT(refusal(camera("a", "distortion.model = \"fisheye\"")), HasSubstr("kannala_brandt"));
  EXPECT_THAT(refusal(camera("a", "time_offset = 2.0")), HasSubstr("camera 'a': time_offset"));
  EXPECT_THAT(refusal("[[camera]]\nname = \"a\"\nwidth = 64\n"), HasSubstr("camera 'a': "));
}

constexpr const char* kPanorama =
    "[[camera]]\nname = \"p\"\nprojection = \"equirectangular\"\nwidth = 64\nheight = 32\n";

TEST(RigFile, ReadsEquirectangularCameras) {
  const vo::Rig rig = read(camera("a") + kPanorama + "position = [0, 1, 0]\ntime_offset = 0.01\n" +
                           "[camera.sensor]\nexposure = 2.0\n");
  const vo::CameraModel& panorama = rig.cameras[1].camera.model;
  EXPECT_EQ(rig.cameras[0].camera.model.projection(), vo::CameraProjection::pinhole);
  EXPECT_EQ(panorama.projection(), vo::CameraProjection::equirectangular);
  EXPECT_EQ(panorama.height(), 32);
  EXPECT_EQ(rig.cameras[1].time_offset, 0.01);
  const std::string text = vo::format_rig(rig);
  EXPECT_EQ(vo::format_rig(read(text)), text);
}

TEST(RigFile, RefusesWhatAnEquirectangularCameraDoesNotHave) {
  const std::string panorama = kPanorama;
  EXPECT_THAT(refusal(panorama + "cx = 3.0\n"), HasSubstr("rig.toml:6: cx: expected none beside"));
  EXPECT_THAT(refusal("[[camera]]\nname = \"p\"\nprojection = \"equirectangular\"\nwidth = 9\n"),
              HasSubstr("rig.toml:1: camera 'p': camera: expected a size"));
  EXPECT_THAT(refusal(panorama + "stereo = \"a\"\n" + camera("a", "position = [0.1, 0, 0]")),
              HasSubstr("rig.toml:1: camera 'p': stereo = \"a\": expected a pinhole camera, got "
                        "projection = \"equirectangular\""));
}

TEST(RigFile, RefusesPosesThatAreNone) {
  EXPECT_THAT(refusal(camera("a", "T_body_camera = [1,0,0,0, 0,1,0,0, 0,0,2,0, 0,0,0,1]")),
              HasSubstr("camera 'a': T_body_camera: expected a rotation"));
  EXPECT_THAT(refusal(camera("a", "T_body_camera = [1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1]")),
              HasSubstr("camera 'a': T_body_camera: expected a rotation"));
  EXPECT_THAT(refusal(camera("a", "T_body_camera = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,1,1]")),
              HasSubstr("expected 0, 0, 0, 1 as the fourth row"));
  EXPECT_THAT(refusal(camera("a", "orientation = [0, 0, 0, 2]")),
              HasSubstr("camera 'a': expected a quaternion of length 1"));
  EXPECT_THAT(refusal(camera("a", "position = [0, 0]")), HasSubstr("position"));
  EXPECT_THAT(refusal(camera("a",
                             "position = [0, 0, 0]\nT_body_camera = [1,0,0,0, 0,1,0,0, "
                             "0,0,1,0, 0,0,0,1]")),
              HasSubstr("not both"));
  EXPECT_THAT(refusal("[imu]\norientation = [0, 0, 0, 0]\n" + camera("a")), HasSubstr(": imu: "));
}

TEST(RigFile, RefusesPairsThatAreNotRectified) {
  const auto pair = [](const std::string& right, const std::string& left = "") {
    return refusal(camera("l", "stereo = \"r\"\n" + left) + camera("r", right));
  };
  EXPECT_THAT(pair("position = [-0.1, 0, 0]"),
              HasSubstr("camera 'l': stereo = \"r\": expected a partner to the right, at a "
                        "positive baseline"));
  EXPECT_THAT(pair("position = [0, 0, 0]"), HasSubstr("at a positive baseline"));
  EXPECT_THAT(pair("position = [0.1, 0.001, 0]"), HasSubstr("whose baseline is along x"));
  EXPECT_THAT(pair("position = [0.1, 0, 0]\norientation = [0, 0.001, 0, 0.9999995]"),
              HasSubstr("whose axes are parallel"));
  EXPECT_THAT(pair("position = [0.1, 0, 0]\ntime_offset = 0.01"), HasSubstr("time_offset"));
  EXPECT_THAT(pair("position = [0.1, 0, 0]\ndistortion.k1 = 0.1"), HasSubstr("distortion.k1"));
  EXPECT_THAT(pair("position = [0.1, 0, 0]\ndistortion.k1 = 0.1", "distortion.k1 = 0.1"),
              HasSubstr("have no distortion"));
  EXPECT_THAT(refusal(camera("l", "stereo = \"x\"")), HasSubstr("the name of another camera"));
  EXPECT_THAT(refusal(camera("l", "stereo = \"l\"")), HasSubstr("baseline above 0"));
}

}  // namespace
