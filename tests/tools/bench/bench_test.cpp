#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/plane_sequence.h"
#include "tests/support/program.h"
#include "tests/support/temp_folder.h"
#include "tests/support/textured_plane.h"
#include "tools/bench/bench_report.h"
#include "tools/bench/frames.h"
#include "tools/bench/peer.h"
#include "tools/bench/race.h"
#include "tools/bench/summary.h"
#include "tools/plot/linear_fit.h"
#include "vo/files/input.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace {

using nlohmann::json;
using support::TempFolder;
using testing::HasSubstr;

constexpr std::size_t kFrames = 12;

tools::Frames plane_frames() {
  const TempFolder folder;
  support::write_plane_sequence(folder.path(), kFrames);
  return tools::load_frames(vo::SequenceReader(folder.path()), 100, [](auto, auto) {});
}

/// Tracks nothing; its frames cost 1, 2, 3, ... ms, and `scale` times that.
tools::Peer clockwork(const std::string& name, double scale, std::vector<std::string>& log) {
  return {name, [=, &log](const vo::PinholeCamera&) {
            return [=, &log, frame = 0](const vo::RgbdFrame&) mutable {
              log.push_back(name);
              tools::FrameSample sample;
              sample.costs.alignment_ms = scale * ++frame;
              sample.T_world_camera = vo::SE3();
              return sample;
            };
          }};
}

TEST(BenchFrames, AreInMemoryWhenTheFolderIsGone) {
  const tools::Frames input = plane_frames();
  ASSERT_EQ(input.frames.size(), kFrames) << "all there are, where more were asked for";
  const auto results =
      tools::race(input, tools::line_up({"edvo"}).peers, {.repeats = 1}, [](auto, auto) {});
  for (const tools::RaceResult& result : results) {
    EXPECT_EQ(tools::trajectory(result, input).size(), kFrames) << result.name;
  }
}

TEST(BenchFrames, AResizedCameraSeesTheSamePointsAtScaledPixels) {
  vo::PinholeCamera camera{640, 480, 517.3, 516.5, 318.6, 255.3, {0.26, -0.95, -0.005, 0.002, 1.2}};
  for (const cv::Size size : {cv::Size(160, 120), cv::Size(1280, 960), cv::Size(300, 200)}) {
    const vo::PinholeCamera other = tools::resized(camera, size);
    EXPECT_NO_THROW(other.validate());
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.3, -0.2, 1.5), {-0.5, 0.4, 2}, {0, 0, 1}}) {
      const Eigen::Vector2d pixel = camera.project(p);
      const Eigen::Vector2d expected((pixel.x() + 0.5) * size.width / 640 - 0.5,
                                     (pixel.y() + 0.5) * size.height / 480 - 0.5);
      EXPECT_LT((other.project(p) - expected).norm(), 1e-9) << "px";
    }
  }
}

/// Depth must be a value of the original, of a pixel at most half a pixel of the coarser image
/// away.
TEST(BenchFrames, AResizedFrameHasTheDepthOfTheNearestPixel) {
  vo::RgbdFrame frame{0, vo::ByteImage(96, 128, uchar{0}), vo::DepthImage(96, 128)};
  for (int v = 0; v < 96; ++v) {
    for (int u = 0; u < 128; ++u) {
      frame.depth(v, u) = static_cast<float>(1 + u + 128 * v);
    }
  }
  for (const cv::Size size : {cv::Size(32, 24), cv::Size(64, 48), cv::Size(256, 192)}) {
    const vo::RgbdFrame other = tools::resized(frame, size);
    ASSERT_EQ(other.depth.size(), size);
    ASSERT_EQ(other.image.size(), size);
    const double scale = 128.0 / size.width;
    for (int v = 0; v < size.height; ++v) {
      for (int u = 0; u < size.width; ++u) {
        const int index = static_cast<int>(other.depth(v, u)) - 1;
        ASSERT_FLOAT_EQ(other.depth(v, u), static_cast<float>(index + 1)) << "a mean";
        EXPECT_LE(std::abs(index % 128 - ((u + 0.5) * scale - 0.5)), 0.5) << u << " " << v;
        EXPECT_LE(std::abs(index / 128 - ((v + 0.5) * scale - 0.5)), 0.5) << u << " " << v;
      }
    }
  }
}

/// Colour, depth and camera belong together: the plane's depth at the resized camera's own pixels.
TEST(BenchFrames, AResizedFrameMatchesItsCamera) {
  const vo::PinholeCamera camera = support::small_camera();
  const support::TexturedPlane plane;
  const cv::Size size(160, 120);
  const vo::PinholeCamera half = tools::resized(camera, size);
  const vo::RgbdFrame frame = tools::resized(plane.render(camera, {}), size);
  const double slope_m =
      std::abs(plane.depth(camera, {}, {161, 121}) - plane.depth(camera, {}, {160, 120}));
  for (int v = 10; v < 110; v += 20) {
    for (int u = 10; u < 150; u += 20) {
      EXPECT_NEAR(frame.depth(v, u), plane.depth(half, {}, {u, v}), 2 * slope_m);
    }
  }
}

TEST(LinearFit, RecoversALineAndIsTheMeanOfSymmetricErrors) {
  const std::vector<double> x{1, 2, 4, 8};
  const std::vector<double> y{5, 8, 14, 26};  // 2 + 3 x
  const auto line = tools::fit_line(x, y);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->slope, 3, 1e-12);
  EXPECT_NEAR(line->intercept, 2, 1e-12);
  const auto flat =
      tools::fit_line(std::vector<double>{0, 0, 1, 1}, std::vector<double>{1, 3, 2, 4});
  ASSERT_TRUE(flat);
  EXPECT_NEAR(flat->slope, 1, 1e-12);
  EXPECT_NEAR(flat->intercept, 2, 1e-12);
}

TEST(LinearFit, NeedsTwoDifferentX) {
  EXPECT_FALSE(tools::fit_line({}, {}));
  EXPECT_FALSE(tools::fit_line(std::vector<double>{2, 2}, std::vector<double>{1, 3}));
}

TEST(Race, TakesTurnsAndCountsNoWarmUp) {
  tools::Frames input{support::small_camera(), std::vector<vo::RgbdFrame>(25), {}};
  std::vector<std::string> log;
  const tools::RaceOptions options{.warm_up = 5, .repeats = 2};
  const auto results = tools::race(input, {clockwork("a", 1, log), clockwork("b", 10, log)},
                                   options, [](auto, auto) {});
  ASSERT_EQ(log.size(), 100U);
  EXPECT_EQ(log[0], "a");
  EXPECT_EQ(log[10], "b");
  EXPECT_EQ(log[20], "b") << "who begins changes";
  const tools::Summary a = summarize(results[0], input, options);
  EXPECT_EQ(a.median_ms, 15) << "nearest rank of 6 to 25";
  EXPECT_EQ(a.p90_ms, 23);
  EXPECT_EQ(summarize(results[1], input, options).median_ms, 150);
}

TEST(Race, NeedsMoreFramesThanTheWarmUp) {
  const tools::Frames input{support::small_camera(), std::vector<vo::RgbdFrame>(5), {}};
  EXPECT_THROW(tools::race(input, {}, {}, [](auto, auto) {}), vo::Error);
}

/// The clocks must not change what is measured: the same poses as `edvo track` finds.
TEST(Race, TracksAsTheTrackCommandDoes) {
  const TempFolder folder;
  support::write_plane_sequence(folder.path(), kFrames);
  const vo::SequenceReader sequence(folder.path());
  const auto tracked = vo::track_sequence(
      sequence, vo::preset_options(vo::TrackerPreset::best_measured), {}, {}, [](auto, auto) {});
  const tools::Frames input = plane_frames();
  const auto results =
      tools::race(input, tools::line_up({"edvo"}).peers, {.repeats = 2}, [](auto, auto) {});
  ASSERT_EQ(results[1].name, "default");
  const vo::Trajectory raced = tools::trajectory(results[1], input);
  ASSERT_EQ(raced.size(), tracked.trajectory.size());
  for (std::size_t i = 0; i < raced.size(); ++i) {
    EXPECT_EQ(raced[i].T_world_camera.translation(),
              tracked.trajectory[i].T_world_camera.translation());
  }
}

TEST(LineUp, HasEveryPeerOrSaysWhyNot) {
  const tools::LineUp line = tools::line_up(tools::peer_names());
  EXPECT_EQ(line.peers.size() + line.absent.size(), 8U);
  for (const tools::Absence& absence : line.absent) {
    EXPECT_NE(absence.reason, "") << absence.name;
  }
  EXPECT_TRUE(tools::line_up({}).peers.empty());
}

/// The greatest distance between where a motion and its estimate take a pixel of the plane's first
/// frame, px.
double worst_flow_error_px(const vo::SE3& T_world_true, const vo::SE3& T_world_found) {
  const vo::PinholeCamera camera = support::small_camera();
  double worst = 0;
  for (int v = 20; v < camera.height; v += 40) {
    for (int u = 20; u < camera.width; u += 40) {
      const double depth = support::TexturedPlane().depth(camera, {}, {u, v});
      const Eigen::Vector3d p_world = camera.unproject({u, v}, depth);
      const Eigen::Vector2d difference = camera.project(T_world_true.inverse() * p_world) -
                                         camera.project(T_world_found.inverse() * p_world);
      worst = std::max(worst, difference.norm());
    }
  }
  return worst;
}

/// OpenCV compares whole pixels, so it is right to about half of one; the motion is 4 px.
TEST(OpencvPeer, FindsTheMotionToHalfAPixel) {
  const tools::LineUp line = tools::line_up({"opencv-rgbd", "opencv-rgbd-all", "opencv-rgbd-icp"});
  if (line.peers.empty()) {
    GTEST_SKIP() << line.absent.front().reason;
  }
  vo::Vector6d motion;
  motion << 0.02, 0, -0.01, 0, 0, 0.01;
  const vo::SE3 T_world_second = vo::SE3::exp(motion);
  const support::TexturedPlane plane;
  for (const tools::Peer& peer : line.peers) {
    const tools::FrameTracker track = peer.start(support::small_camera());
    track(plane.render(support::small_camera(), {}, 0));
    const auto sample = track(plane.render(support::small_camera(), T_world_second, 1));
    ASSERT_TRUE(sample.T_world_camera) << peer.name;
    EXPECT_LT(worst_flow_error_px(T_world_second, *sample.T_world_camera), 0.5) << peer.name;
    EXPECT_GT(sample.points, 1000U) << peer.name;
  }
}

TEST(BenchReport, TheYardstickIsOpencvElseTheSlowest) {
  EXPECT_EQ(tools::yardstick({{.name = "a", .cpu_ms = 1}}), nullptr);
  std::vector<tools::Summary> rows{{.name = "a", .cpu_ms = 4}, {.name = "b", .cpu_ms = 20}};
  EXPECT_EQ(tools::yardstick(rows)->name, "b");
  rows.insert(rows.begin(), {.name = "opencv-rgbd", .cpu_ms = 10});
  EXPECT_EQ(tools::yardstick(rows)->name, "opencv-rgbd");
  const json report = tools::bench_json({.peers = rows});
  EXPECT_EQ(report["contestants"][1]["faster_than"]["ratio"], 2.5);
  EXPECT_EQ(report["contestants"][2]["faster_than"]["ratio"], 0.5);
}

TEST(BenchProgram, PrintsItsContract) {
  const TempFolder folder;
  support::write_plane_sequence(folder.path() / "sequence", 45);
  const std::string out = (folder.path() / "bench.json").string();
  const support::ProgramResult result = support::run_program(
      "bench '" + (folder.path() / "sequence").string() +
      "' --peers edvo --repeat 1 --set align.threads=2 --growth --quiet --json --out '" + out +
      "'");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(vo::read_file(out), result.out);
  const json report = json::parse(result.out);
  EXPECT_EQ(report["threads"], 1);
  EXPECT_EQ(report["frames"], 45);
  EXPECT_EQ(report["width"], 160);
  EXPECT_NE(report["cpu"], "");
  for (const json& row : report["contestants"]) {
    for (const char* stage : {"median", "p90", "cpu", "pyramid", "edges", "alignment", "map"}) {
      EXPECT_GE(row["ms_per_frame"][stage], 0) << stage;
    }
    EXPECT_GT(row["points"], 100);
    EXPECT_GT(row["map_mib"], 0);
    EXPECT_EQ(row["tracked_fraction"], 1.0);
    EXPECT_LT(row["accuracy"]["rpe_translation_rmse_m"], 0.03) << row["name"];
  }
  EXPECT_EQ(report["contestants"].back()["name"], "default-set");
  ASSERT_EQ(report["growth"].size(), 3U);
  EXPECT_EQ(report["growth"][0]["rows"].size(), 6U);
  EXPECT_EQ(report["growth"][1]["rows"].size(), 5U);
  EXPECT_EQ(report["growth"][2]["rows"][1]["pixels"], 80 * 60);
  EXPECT_TRUE(report["growth"][0].contains("fit"));
}

TEST(BenchProgram, TableHasAColumnForEveryTitle) {
  tools::BenchReport report{.peers = {{.name = "paper", .cpu_ms = 2}},
                            .absent = {{"dense", "no such option"}}};
  const std::string table = tools::bench_table(report);
  EXPECT_THAT(table, HasSubstr("threads: 1"));
  EXPECT_THAT(table, HasSubstr("dense: no such option"));
  std::vector<std::size_t> widths;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" | ") != std::string::npos) {
      widths.push_back(line.size());
      EXPECT_EQ(line.find(" | "), 49U) << line;
    }
  }
  EXPECT_THAT(widths, testing::ElementsAre(widths[0], widths[0]));
}

TEST(BenchProgram, RefusesWhatItCannotDo) {
  EXPECT_EQ(support::run_program("bench nowhere --quiet").exit_code, 3);
  EXPECT_EQ(support::run_program("bench nowhere --peers orb").exit_code, 2);
  EXPECT_EQ(support::run_program("bench a.toml --camera tum-fr1").exit_code, 2);
}

}  // namespace
