#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"
#include "tests/support/temp_folder.h"
#include "tools/train_edges/edge_patch.h"
#include "tools/train_edges/edge_score.h"
#include "tools/train_edges/forest_trainer.h"
#include "tools/train_edges/label_space.h"
#include "vo/files/input.h"
#include "vo/structured_forest/structured_forest_file.h"

namespace {

using nlohmann::json;
using support::run_program;
using support::TempFolder;
using testing::HasSubstr;
using tools::EdgePatch;

constexpr int kSide = tools::kPatchSide;

/// Column `u` of the patch is an edge.
EdgePatch upright_edge(int u) {
  EdgePatch patch;
  for (int v = 0; v < kSide; ++v) {
    patch.set(static_cast<std::size_t>(kSide * u + v));
  }
  return patch;
}

TEST(LineBetween, CrossesAnEdgeExactlyIfItSeparatesTheEnds) {
  vo::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const cv::Point a(random.below(kSide), random.below(kSide));
    const cv::Point b(random.below(kSide), random.below(kSide));
    const bool is_separated = std::min(a.x, b.x) < 8 && std::max(a.x, b.x) > 8;
    if (a.x != 8 && b.x != 8) {
      EXPECT_EQ((tools::line_between(a, b) & upright_edge(8)).any(), is_separated) << a << b;
    }
  }
}

TEST(LineBetween, HasNoGapForADiagonalEdge) {
  EdgePatch diagonal;
  for (int i = 0; i < kSide; ++i) {
    diagonal.set(static_cast<std::size_t>(kSide * i + i));
  }
  vo::Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const cv::Point a(random.below(kSide), random.below(kSide));
    const cv::Point b(random.below(kSide), random.below(kSide));
    if ((a.x - a.y) * (b.x - b.y) < 0) {
      EXPECT_TRUE((tools::line_between(a, b) & diagonal).any()) << a << b;
    }
  }
}

TEST(TwoClasses, DivideLikeFromUnlikeEdges) {
  std::vector<EdgePatch> patches;
  for (int i = 0; i < 20; ++i) {
    patches.push_back(i % 2 == 0 ? upright_edge(4) : upright_edge(12));
  }
  vo::Random random(5);
  const auto lines = tools::random_lines(64, random);
  const std::vector<bool> classes = tools::two_classes(tools::separations(patches, lines));
  ASSERT_EQ(classes.size(), patches.size());
  for (std::size_t i = 0; i + 2 < classes.size(); ++i) {
    EXPECT_EQ(classes[i], classes[i + 2]);
    EXPECT_NE(classes[i], classes[i + 1]);
  }
  EXPECT_TRUE(tools::two_classes(tools::separations({patches[0], patches[2]}, lines)).empty());
}

TEST(Medoid, IsOneOfTheMajority) {
  vo::Random random(6);
  const auto lines = tools::random_lines(64, random);
  const std::vector<EdgePatch> patches = {upright_edge(2), upright_edge(8), upright_edge(8)};
  EXPECT_NE(tools::medoid(tools::separations(patches, lines)), 0U);
}

/// Labels in column 20, detections in column 20 + offset: right within 2 px.
TEST(EdgeScore, CountsWhatLiesWithinTwoPixels) {
  synth::EdgeLabels labels(30, 40, uchar{0});
  labels.col(20) = synth::bit(synth::EdgeCause::depth);
  labels(cv::Rect(20, 0, 1, 10)) =
      synth::bit(synth::EdgeCause::depth) | synth::bit(synth::EdgeCause::shadow);
  for (const int offset : {-3, -2, 0, 2, 3}) {
    vo::EdgeMask detected(30, 40, uchar{0});
    detected(cv::Rect(20 + offset, 0, 1, 10)) = 255;
    const tools::EdgeScore score = tools::score_edges(detected, labels);
    const bool is_near = std::abs(offset) <= 2;
    EXPECT_EQ(score.precision(), is_near ? 1 : 0);
    const int below = offset == 0 ? 2 : 0;  // of its end; beside it the distance is over 2 px
    EXPECT_NEAR(score.recall(), is_near ? (10 + below) / 30.0 : 0, 1e-9);
    EXPECT_EQ(score.recall_of(synth::EdgeCause::shadow), is_near ? 1 : 0);
    EXPECT_EQ(score.recall_of(synth::EdgeCause::crease), 1) << "no creases: nothing missed";
  }
  EXPECT_EQ(tools::score_edges(vo::EdgeMask(30, 40, uchar{0}), labels).precision(), 1);
}

/// Grey with a step of random height at a random place, upright or level; its border is the edge.
std::vector<tools::LabelledView> step_views(int count, std::uint64_t seed) {
  std::vector<tools::LabelledView> views;
  for (int i = 0; i < count; ++i) {
    vo::Random random(seed, static_cast<std::uint64_t>(i));
    tools::LabelledView view{vo::ColorImage(64, 64), synth::EdgeLabels(64, 64, uchar{0})};
    const int dark = random.below(150);
    const int bright = dark + 40 + random.below(60);
    const int at = 12 + random.below(40);
    view.image = cv::Vec3b::all(static_cast<uchar>(dark));
    view.image.colRange(at + 1, 64) = cv::Vec3b::all(static_cast<uchar>(bright));
    view.labels.col(at) = synth::bit(synth::EdgeCause::albedo);
    if (i % 2 == 1) {
      cv::transpose(view.image, view.image);
      cv::transpose(view.labels, view.labels);
    }
    views.push_back(view);
  }
  return views;
}

const tools::ForestTrainingOptions kSmall{
    .trees = 4, .scale = 1, .patches_per_view = 60, .tree = {.max_leaves = 60}};

TEST(TrainForest, LearnsStepsThatItHasNotSeen) {
  const vo::StructuredForest forest = tools::train_forest(step_views(60, 1), kSmall, 1, {});
  tools::EdgeScore score;
  for (const tools::LabelledView& view : step_views(20, 2)) {
    score += tools::score_edges(forest_edges(forest, vo::to_rgb(view.image), 1, 0.2), view.labels);
  }
  EXPECT_GT(score.precision(), 0.95);
  EXPECT_GT(score.recall(), 0.95);
}

TEST(TrainForest, GivesTheSameModelFromTheSameSeed) {
  const auto views = step_views(10, 1);
  const std::string model = structured_forest_yaml(tools::train_forest(views, kSmall, 1, {}));
  EXPECT_EQ(structured_forest_yaml(tools::train_forest(views, kSmall, 1, {})), model);
  EXPECT_NE(structured_forest_yaml(tools::train_forest(views, kSmall, 2, {})), model);
}

TEST(TrainEdgesProgram, TrainsAndJudgesTheSameOnAnyNumberOfThreads) {
  const TempFolder folder;
  const std::string room = std::string("'") + EDVO_SOURCE_DIR + "/assets/room/room.gltf'";
  const std::string small = room + " --views 3 --width 96 --height 64 --json --quiet";
  for (const char* threads : {"1", "2"}) {
    const auto result =
        run_program("train-edges " + small + " --trees 2 --tree.max-leaves 20 --threads " +
                    threads + " --out '" + (folder.path() / threads).string() + ".yml.gz'");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(json::parse(result.out)["trees"], 2);
  }
  const auto model = folder.path() / "1.yml.gz";
  EXPECT_EQ(vo::read_file(model), vo::read_file(folder.path() / "2.yml.gz"));
  const auto picture = folder.path() / "comparison.png";
  const auto judged = run_program("train-edges " + small + " --evaluate '" + model.string() +
                                  "' --picture '" + picture.string() + "'");
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_EQ(json::parse(judged.out)["detectors"].size(), 5U);
  EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST(TrainEdgesProgram, SaysWhatIsWrong) {
  const std::string room = std::string("'") + EDVO_SOURCE_DIR + "/assets/room/room.gltf'";
  EXPECT_EQ(run_program("train-edges " + room).exit_code, 2) << "neither --out nor --evaluate";
  EXPECT_EQ(run_program("train-edges " + room + " --out a.yml --views 0").exit_code, 2);
  const auto result = run_program("train-edges " + room + " --evaluate " + room);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("room.gltf: "));
}

}  // namespace
