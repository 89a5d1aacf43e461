#include <filesystem>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tools/scenario/run_scenario.h"
#include "vo/evaluation/evaluate.h"
#include "vo/image_files/png.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/tracking/tracker.h"

namespace {

using vo::ViewTiles;

constexpr std::size_t kFrames = 75;
constexpr std::size_t kStart = 10;  // frames, before somebody comes into view

/// Renders the first frames of a scenario with the exact channel `moving`.
void render_start(const std::string& name, const std::filesystem::path& out) {
  const std::filesystem::path file =
      std::filesystem::path(EDVO_SOURCE_DIR) / "scenarios" / (name + ".toml");
  synth::RenderJob job = tools::render_job(tools::load_scenario(file, {{"render.samples", "1"}}));
  job.recipe.truth.resize(kFrames);
  job.recipe.channels.channels = {synth::TruthChannel::moving};
  synth::render_sequence(job, out, vo::ExistingOutput::replace, [](std::size_t, std::size_t) {});
}

/// Counts tiles by whether most of their pixels move in truth, and as found.
struct TileCounts {
  double right = 0, missed = 0, wrong = 0;

  void add(const cv::Mat& truth, const vo::TileMask& found) {
    const cv::Size tile(truth.cols / ViewTiles::kColumns, truth.rows / ViewTiles::kRows);
    for (std::size_t i = 0; i < ViewTiles::kCount; ++i) {
      const cv::Point corner(static_cast<int>(i) % ViewTiles::kColumns * tile.width,
                             static_cast<int>(i) / ViewTiles::kColumns * tile.height);
      const bool moves = 2 * cv::countNonZero(truth(cv::Rect(corner, tile))) > tile.area();
      right += moves && found[i] ? 1 : 0;
      missed += moves && !found[i] ? 1 : 0;
      wrong += !moves && found[i] ? 1 : 0;
    }
  }
  double recall() const { return right / (right + missed); }
  double precision() const { return right / (right + wrong); }
};

/// Somebody walks through the view of a camera in a hand. The tiles that are found to move are
/// compared with those that do; an outline is a tile's width wide, and shadows move, too.
TEST(MotionSegmentation, FindsTheVisitorThatTheRendererKnows) {
  const support::TempFolder folder;
  const std::filesystem::path out = folder.path() / "sequence";
  render_start("visitor_25", out);
  const vo::SequenceReader sequence(out);
  vo::RgbdOdometry odometry(sequence.camera().pinhole);
  TileCounts counts;
  for (std::size_t i = 0; i < kFrames; ++i) {
    const vo::TrackingResult result = odometry.track(sequence.read(i));
    EXPECT_NE(result.status, vo::TrackingStatus::lost) << i;
    if (i < kStart) {
      EXPECT_LT(result.moving_fraction, 0.03) << i;
    }
    const std::string digits = std::to_string(1000000 + i).substr(1);
    counts.add(vo::read_png(out / "truth" / "moving" / (digits + ".png")),
               odometry.tracker().segmentation().moving());
  }
  std::cout << "recall " << counts.recall() << ", precision " << counts.precision() << '\n';
  EXPECT_GT(counts.recall(), 0.8);
  EXPECT_GT(counts.precision(), 0.7);
  const vo::TrajectoryErrors errors = vo::evaluate(sequence.ground_truth(), odometry.trajectory());
  EXPECT_LT(errors.ate.rmse, 0.004);
}

}  // namespace
