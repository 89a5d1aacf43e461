#include <algorithm>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/plane_sequence.h"
#include "tests/support/program.h"
#include "tools/depth/depth_errors.h"
#include "vo/files/output.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"

namespace {

using support::run_program;
using support::TempFolder;
using testing::HasSubstr;

/// The plane at 160x120, 5 mm a frame: enough to find most of its depth.
TEST(DepthProgram, MapsASequenceAndJudgesIt) {
  const TempFolder folder;
  const std::filesystem::path sequence = folder.path() / "sequence";
  support::write_plane_sequence(sequence, 20);
  const std::filesystem::path out = folder.path() / "maps";
  const support::ProgramResult result = run_program("depth '" + sequence.string() + "' --out '" +
                                                    out.string() + "' --every 10 --json -q");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json summary = nlohmann::json::parse(result.out);
  EXPECT_EQ(summary.at("frames"), 20);
  EXPECT_NEAR(summary.at("scale").get<double>(), 1, 0.02);
  EXPECT_LT(summary.at("errors").at(0).at("median_percent").get<double>(), 4);
  for (const char* name :
       {"depth.csv", "course.svg", "cloud.ply", "cloud.pcd", "000000.png", "000010.png"}) {
    EXPECT_TRUE(std::filesystem::exists(out / name)) << name;
  }
  EXPECT_FALSE(support::has_leftovers(folder.path()));
}

TEST(TrackProgram, MonoReadsTheFirstDepthAlone) {
  const TempFolder folder;
  const std::filesystem::path sequence = folder.path() / "sequence";
  support::write_plane_sequence(sequence, 8);
  for (int i = 1; i < 8; ++i) {
    std::filesystem::remove(sequence / ("depth/00000" + std::to_string(i) + ".png"));
  }
  const std::string out = (folder.path() / "e.txt").string();
  const support::ProgramResult result = run_program(
      "track '" + sequence.string() + "' --mode mono --bootstrap rgbd --out '" + out + "' -q");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("8 of 8 frames tracked"));
}

TEST(TrackProgram, ADepthFileOfAnotherSizeOrUnitIsRefused) {
  const TempFolder folder;
  const std::filesystem::path sequence = folder.path() / "sequence";
  support::write_plane_sequence(sequence, 3);
  const auto refusal = [&](const vo::DepthImage& depth) {
    const std::filesystem::path file = folder.write("depth.npy", vo::encode_npy(depth));
    const support::ProgramResult result = run_program(
        "track '" + sequence.string() + "' --mode mono --bootstrap file --depth-file '" +
        file.string() + "' --out '" + (folder.path() / "e.txt").string() + "' -q");
    EXPECT_EQ(result.exit_code, 3);
    return result.err;
  };
  EXPECT_THAT(refusal(vo::DepthImage(60, 80, 2.0F)),
              HasSubstr("is 80x60 px, expected the camera's 160x120"));
  EXPECT_THAT(refusal(vo::DepthImage(120, 160, 2000.0F)), HasSubstr("median depth of 2000 m"));
}

/// Depths that are 3 % too far, and on the left wrong by half. At the step between, sides are in
/// doubt.
TEST(MapErrors, CountWhatWasPutIn) {
  const vo::PinholeCamera camera = support::small_camera();
  vo::RgbdFrame frame = support::TexturedPlane().render(camera, {});
  const vo::DepthImage truth = frame.depth.clone();
  frame.depth = vo::DepthImage();
  vo::FramePyramid host = vo::build_pyramid(frame, camera, vo::PyramidOptions());
  vo::add_edges(host, vo::EdgeOptions());
  vo::DepthMap map({});
  map.start(host, 2);
  vo::DepthImage wrong = truth.clone();
  wrong *= 1.03F;
  constexpr int kStep = 40;  // px
  wrong.colRange(0, kStep) *= 1.5F;
  const std::vector<cv::Point>& pixels = map.hypotheses().pixel;
  const auto in_columns = [&](int first, int end) {
    return static_cast<double>(std::count_if(pixels.begin(), pixels.end(), [&](cv::Point pixel) {
      return pixel.x >= first && pixel.x < end;
    }));
  };
  const double outliers = in_columns(0, kStep - 1);
  const double count = outliers + in_columns(kStep + 1, camera.width);
  map.take_depth(wrong, 0.03);
  const tools::MapErrors errors = tools::map_errors(map, {.depth = truth, .causes = {}}, {});
  EXPECT_EQ(static_cast<double>(errors.confident.count), count);
  EXPECT_NEAR(errors.confident.outliers_percent, 100 * outliers / count, 1e-9);
  EXPECT_NEAR(errors.confident.median_percent, 2.9, 0.6);
  EXPECT_NEAR(errors.scale, 1 / 1.03, 0.006);
  EXPECT_NEAR(errors.density_percent, 100 * count / static_cast<double>(pixels.size()), 1e-9);
  EXPECT_EQ(errors.depth_step.count, 0U);
  EXPECT_EQ(errors.without_cause.count, 0U) << "nobody knows the causes";
}

/// Errors of equal deviation s, judged by a reference of deviation r, have 1 + (r/s)^2 times less
/// NEES.
TEST(MapErrors, AllowForTheNoiseOfTheReference) {
  const vo::PinholeCamera camera = support::small_camera();
  const vo::RgbdFrame frame = support::TexturedPlane().render(camera, {});
  vo::FramePyramid host = vo::build_pyramid({0, frame.image, {}}, camera, vo::PyramidOptions());
  vo::add_edges(host, vo::EdgeOptions());
  vo::DepthMap map({});
  map.start(host, 2);
  vo::DepthImage wrong = frame.depth.clone();
  wrong *= 1.02F;
  map.take_depth(wrong, 0.03);
  const std::vector<float>& variances = map.hypotheses().smoothed_variance;
  const auto [least, most] = std::minmax_element(variances.begin(), variances.end());
  constexpr double kNoise = 0.05;  // 1/m
  const double exact =
      tools::map_errors(map, {.depth = frame.depth, .causes = {}}, {}).confident.nees;
  const double noisy =
      tools::map_errors(map, {.depth = frame.depth, .causes = {}, .depth_noise = kNoise}, {})
          .confident.nees;
  EXPECT_GE(exact / noisy, 1 + kNoise * kNoise / *most);
  EXPECT_LE(exact / noisy, 1 + kNoise * kNoise / *least);
}

/// Left albedo, right crease and shadow, nothing between.
TEST(MapErrors, AreToldByTheCausesOfEdges) {
  const vo::PinholeCamera camera = support::small_camera();
  const vo::RgbdFrame frame = support::TexturedPlane().render(camera, {});
  vo::FramePyramid host = vo::build_pyramid({0, frame.image, {}}, camera, vo::PyramidOptions());
  vo::add_edges(host, vo::EdgeOptions());
  vo::DepthMap map({});
  map.start(host, 2);
  map.take_depth(frame.depth, 0.01);
  constexpr int kLeft = 60;   // px
  constexpr int kRight = 90;  // px
  synth::EdgeLabels causes(camera.height, camera.width, std::uint8_t{0});
  causes.colRange(0, kLeft).setTo(4);
  causes.colRange(kRight, camera.width).setTo(2 + 8);
  std::size_t left = 0;
  std::size_t right = 0;
  for (const cv::Point& pixel : map.hypotheses().pixel) {
    left += pixel.x <= kLeft ? 1U : 0U;
    right += pixel.x >= kRight - 1 ? 1U : 0U;
  }
  const tools::MapErrors errors =
      tools::map_errors(map, {.depth = frame.depth, .causes = causes}, {});
  EXPECT_EQ(errors.by_cause[0].count, 0U);
  EXPECT_EQ(errors.by_cause[1].count, right);
  EXPECT_EQ(errors.by_cause[2].count, left);
  EXPECT_EQ(errors.by_cause[3].count, right);
  EXPECT_EQ(errors.without_cause.count, map.hypotheses().size() - left - right);
}

TEST(DepthProgram, ReadsTheRenderersExactEdges) {
  const TempFolder folder;
  const std::filesystem::path sequence = folder.path() / "sequence";
  support::write_plane_sequence(sequence, 12);
  const vo::ByteImage labels(120, 160, std::uint8_t{4});
  std::filesystem::create_directories(sequence / "truth/edges");
  vo::write_file(sequence / "truth/edges/000000.png", vo::encode_png(labels));
  const std::string command = "depth '" + sequence.string() + "' --set map.host.max_flow=1 -q";
  EXPECT_THAT(run_program(command).out, HasSubstr("edge_albedo"));
  std::filesystem::remove_all(sequence / "truth");
  EXPECT_THAT(run_program(command).out, testing::Not(HasSubstr("edge_")));
}

}  // namespace
