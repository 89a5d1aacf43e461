#include "tools/scenario/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/sensor/preset.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::EndsWith;
using testing::HasSubstr;

constexpr const char* kScenario = R"(why = "it would fail if"
[scene]
gltf = "room/room.gltf"
[path]
kind = "orbit"
duration = 2
[odometry]
tracker.pyramid.levels = 4
preset = "paper"
[expect]
ate_rmse_m = { max = 0.01 }
keyframes = { min = 3, max = 12 }
)";

tools::Scenario load(const std::string& text) {
  const TempFolder folder;
  return tools::load_scenario(folder.write("s.toml", text));
}

std::string error_with(const std::string& text, const std::string& replacement) {
  std::string scenario = kScenario;
  scenario.replace(scenario.find(text), text.size(), replacement);
  return error_text([&] { load(scenario); });
}

TEST(Scenario, ReadsWhatTheFileSaysAndKeepsTheDefaults) {
  const tools::Scenario scenario = load(kScenario);
  EXPECT_EQ(scenario.name, "s");
  EXPECT_EQ(scenario.path.duration, 2);
  EXPECT_EQ(scenario.path.rate, synth::PathOptions{}.rate);
  EXPECT_EQ(scenario.expect.at("ate_rmse_m").max, 0.01);
  EXPECT_TRUE(scenario.expect.at("ate_rmse_m").contains(0));
  EXPECT_FALSE(scenario.expect.at("keyframes").contains(2));
  EXPECT_FALSE(scenario.expect.at("keyframes").contains(std::nan("")));
  EXPECT_THAT(scenario.scene_file().string(), EndsWith("/assets/room/room.gltf"));
}

TEST(Scenario, SaysWhatOfTheFileIsPlayed) {
  const std::string key = "gltf = \"room/room.gltf\"\n";
  std::string text = kScenario;
  text.insert(text.find(key) + key.size(), "animation = \"none\"\nloop = true\n");
  const tools::Scenario scenario = load(text);
  EXPECT_EQ(scenario.scene.parts.animation, "none");
  EXPECT_TRUE(scenario.scene.parts.loop);
}

TEST(Scenario, ReadsChannelsClassesAndActors) {
  const tools::Scenario scenario =
      load(std::string("channels = 'instance,class'\n") + kScenario +
           "[[class]]\nname = 'chair'\nnodes = ['*chair*', 'stool']\n"
           "[[class]]\nname = 'wood'\nmaterials = ['oak']\n"
           "[[actor]]\nfile = 'walker/walker.gltf'\npath = [[0, 0, 1], [0, 0, 2]]\nspeed = 2\n");
  ASSERT_EQ(scenario.classes.size(), 2U);
  EXPECT_EQ(scenario.classes[0].name, "chair");
  EXPECT_THAT(scenario.classes[0].nodes, testing::ElementsAre("*chair*", "stool"));
  EXPECT_THAT(scenario.classes[1].materials, testing::ElementsAre("oak"));
  EXPECT_TRUE(scenario.truth().has(synth::TruthChannel::surface_class));
  ASSERT_EQ(scenario.actors.size(), 1U);
  EXPECT_THAT(scenario.actors[0].file.string(), EndsWith("/assets/walker/walker.gltf"));
  EXPECT_EQ(scenario.actors[0].speed, 2);
  EXPECT_EQ(scenario.actors[0].path.at(1), Eigen::Vector3d(0, 0, 2));
}

TEST(Scenario, ErrorsOfTablesNameTheirLine) {
  const auto error_of = [](const std::string& tables) {
    return error_text([&] { load(std::string(kScenario) + tables); });
  };
  EXPECT_THAT(error_of("[[actor]]\nfile = 'a.gltf'\npath = [[0, 0, 0], [1, 0, 0]]\nspeed = 0\n"),
              HasSubstr("actor: speed: is 0, expected a positive number of m/s"));
  EXPECT_THAT(error_of("[[actor]]\nspede = 0\n"),
              HasSubstr("unknown key 'actor.0.spede'; the nearest known key is actor.0.speed"));
  EXPECT_THAT(error_of("[[class]]\nname = 'a'\n"),
              EndsWith("class a: expected patterns of nodes or materials"));
  EXPECT_THAT(error_of("[class]\nname = 'a'\n"), EndsWith("class.name: expected tables [[class]]"));
  std::string text = std::string("channels = 'class'\n") + kScenario;
  EXPECT_THAT(error_text([&] { load(text); }), HasSubstr("channels: class: there are no classes"));
}

TEST(Scenario, APresetIsWhereTheOptionsStartFromWhereverItStands) {
  const tools::Scenario scenario = load(kScenario);
  EXPECT_EQ(scenario.odometry.tracker.pyramid.levels, 4);
  EXPECT_EQ(scenario.odometry.tracker.points.source, vo::EdgeSource::current);
  EXPECT_EQ(scenario.odometry.tracker.lens, vo::LensModel::ignore);
}

TEST(Scenario, ASensorPresetMayComeFromTheFileOrFromAChange) {
  const TempFolder folder;
  const auto file = folder.write(
      "s.toml", std::string(kScenario) + "[sensor]\npreset = \"azure-kinect\"\nmin_depth = 0.7\n");
  EXPECT_EQ(tools::load_scenario(file, {}).sensor.max_depth, 3.86);
  const tools::Scenario changed = tools::load_scenario(file, {{"sensor.preset", "kinect-v1"}});
  const synth::SensorOptions kinect = synth::preset_options(synth::SensorPreset::kinect_v1);
  EXPECT_EQ(changed.sensor.max_depth, kinect.max_depth);
  EXPECT_EQ(changed.sensor.depth.delay, kinect.depth.delay);
  EXPECT_EQ(changed.sensor.min_depth, 0.7) << "the file's";
}

TEST(Scenario, ErrorsNameFileLineAndNearestKey) {
  EXPECT_THAT(error_with("duration", "durration"),
              EndsWith("s.toml:6: unknown key 'path.durration'; the nearest known key is "
                       "path.duration"));
  EXPECT_THAT(error_with("ate_rmse_m", "ate_rsme_m"),
              EndsWith("s.toml:11: unknown key 'expect.ate_rsme_m.max'; the nearest known key is "
                       "expect.ate_rmse_m.max"));
  EXPECT_THAT(error_with("max = 0.01", "max = 'low'"),
              EndsWith("s.toml:11: expect.ate_rmse_m.max: expected a number, got \"low\""));
  EXPECT_THAT(error_with("\"orbit\"", "\"circle\""),
              EndsWith("s.toml:5: path.kind: expected one of orbit, spline, trajectory, recorded, "
                       "still, dolly, pan, roll, explore, got 'circle'"));
}

TEST(Scenario, WhatMakesNoSenseIsAnError) {
  EXPECT_THAT(error_with("it would fail if", ""), HasSubstr("s.toml:1: why: expected a sentence"));
  EXPECT_THAT(error_with("duration = 2", "duration = -2"),
              EndsWith("s.toml:6: path.duration: expected above 0, got -2"));
  EXPECT_THAT(error_with("min = 3, max = 12", "min = 13, max = 12"),
              HasSubstr("expect.keyframes: expected min <= max"));
  EXPECT_THAT(error_with("kind = \"orbit\"", "kind = \"spline\""),
              HasSubstr("a spline expects at least two eyes"));
}

TEST(Scenario, AValueThatMakesNoSenseIsNamedByItsLineUnlessAChangeIsAtFault) {
  const TempFolder folder;
  const auto file = folder.write("s.toml",
                                 "why = \"it would fail if\"\n[scene]\ngltf = \"room/room.gltf\"\n"
                                 "[path]\nkind = \"still\"\nmove.eye = [0.0, 0.75, 0.0]\n"
                                 "move.target = [0.0, 0.0, 0.0]\nrate = 5\n");
  const auto error_of = [&](const tools::Assignments& changes) {
    return error_text([&] { tools::load_scenario(file, changes); });
  };
  EXPECT_THAT(error_of({}), HasSubstr("s.toml:7: move: expected a target beside the eye"));
  EXPECT_THAT(error_of({{"path.move.target", "1,0,0"}, {"path.rate", "-1"}}),
              HasSubstr("s.toml: path.rate: expected above 0"));
}

TEST(Scenario, ChangesComeAfterTheFileAndAPresetBeforeThem) {
  const TempFolder folder;
  const auto file = folder.write("s.toml", kScenario);
  const tools::Scenario changed = tools::load_scenario(
      file, {{"odometry.tracker.keyframes.every", "7"}, {"odometry.preset", "default"}});
  EXPECT_EQ(changed.odometry.tracker.pyramid.levels, 4) << "the file's";
  EXPECT_EQ(changed.odometry.tracker.keyframes.every, 7);
  EXPECT_EQ(changed.odometry.tracker.lens, vo::LensModel::distortion) << "the preset's";
  EXPECT_THAT(error_text([&] {
                tools::load_scenario(file, {{"odometry.preset", "best"}});
              }),
              HasSubstr("--set odometry.preset=best: "));
  EXPECT_THAT(error_text([&] {
                tools::load_scenario(file, {{"path.rat", "1"}});
              }),
              HasSubstr("the nearest known key is path.rate"));
}

constexpr const char* kMonoScenario = R"(why = "it would fail if"
[scene]
gltf = "room/room.gltf"
[odometry]
mono.bootstrap = "rgbd"
mono.depth_map.host.every = 5
mode = "mono"
[expect]
depth_error_percent = { max = 0.4 }
)";

TEST(Scenario, TheModeDecidesWhichOptionsThereAre) {
  const tools::Scenario scenario = load(kMonoScenario);
  EXPECT_EQ(scenario.odometry.mode, tools::OdometryMode::mono);
  EXPECT_EQ(scenario.odometry.mono.bootstrap, vo::MonoBootstrap::rgbd);
  EXPECT_EQ(scenario.odometry.mono.map.host.every, 5);
  std::string text = kMonoScenario;
  text.replace(text.find("mono.depth_map.host.every"), 25, "tracker.pyramid.levels");
  EXPECT_THAT(error_text([&] { load(text); }),
              HasSubstr("unknown key 'odometry.tracker.pyramid.levels'"));
}

TEST(Scenario, AMonocularOneHasNoDepthFileToStartFrom) {
  std::string text = kMonoScenario;
  text.replace(text.find("\"rgbd\""), 6, "\"file\"");
  EXPECT_THAT(error_text([&] { load(text); }), HasSubstr("a scenario has no depth file"));
}

}  // namespace
