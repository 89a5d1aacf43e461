// The figures that the TUM benchmark's own scripts and evo print for two estimates of fr1/xyz.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "vo/evaluation/evaluate.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {
namespace {

using nlohmann::json;

const std::filesystem::path kShared = EDVO_SHARED_DATA;

/// In units of the last printed digit.
long long printed(double value) {
  return std::llround(value * 1e6);
}

void expect_printed(const Statistics& statistics, const json& expected, const std::string& prefix,
                    const std::string& suffix = "") {
  const auto compare = [&](const char* name, double value) {
    const std::string key = prefix + name + suffix;
    if (expected.contains(key)) {
      EXPECT_EQ(printed(value), printed(expected.at(key).get<double>())) << key;
    }
  };
  compare("rmse", statistics.rmse);
  compare("mean", statistics.mean);
  compare("median", statistics.median);
  compare("max", statistics.max);
}

void expect_printed(const RelativeErrors& errors, const json& expected) {
  expect_printed(errors.translation, expected, "trans_");
  expect_printed(errors.rotation_deg, expected, "rot_", "_deg");
  if (expected.contains("pairs")) {
    EXPECT_EQ(errors.pairs, expected.at("pairs").get<std::size_t>());
  }
}

class PublishedMetrics : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kShared / "metrics/expected.json")) {
      GTEST_SKIP() << "no folder " << kShared / "metrics";
    }
    std::ifstream file(kShared / "metrics/expected.json");
    const std::string file_name = std::string(GetParam()) + ".txt";
    expected = json::parse(file).at(file_name);
    truth = read_trajectory(kShared / "tum_fr1_xyz/groundtruth.txt");
    estimate = read_trajectory(kShared / "metrics" / file_name);
  }

  TrajectoryErrors evaluate_with(const EvaluationOptions& options) const {
    return evaluate(truth, estimate, options);
  }

  json expected;
  Trajectory truth;
  Trajectory estimate;
};

TEST_P(PublishedMetrics, AteIsThatOfTheBenchmark) {
  const TrajectoryErrors errors = evaluate_with({});
  expect_printed(errors.ate, expected.at("tum_ate"), "");
  EXPECT_EQ(errors.matched, expected.at("tum_ate").at("pairs").get<std::size_t>());
}

TEST_P(PublishedMetrics, RpeOverASecondIsThatOfTheBenchmark) {
  expect_printed(evaluate_with({}).rpe, expected.at("tum_rpe_1s"));
}

TEST_P(PublishedMetrics, AteIsThatOfEvo) {
  expect_printed(evaluate_with({}).ate, expected.at("evo_ape_se3"), "");
  expect_printed(evaluate_with({.alignment = TrajectoryAlignment::sim3}).ate,
                 expected.at("evo_ape_sim3"), "");
}

TEST_P(PublishedMetrics, RpeOverFramesIsThatOfEvo) {
  expect_printed(evaluate_with({.interval = {1, IntervalUnit::frames}}).rpe_evo,
                 expected.at("evo_rpe_1frame"));
  expect_printed(evaluate_with({.interval = {30, IntervalUnit::frames}}).rpe_evo,
                 expected.at("evo_rpe_30frames_all_pairs"));
}

INSTANTIATE_TEST_SUITE_P(Estimates, PublishedMetrics,
                         testing::Values("estimate_refESM_KF", "estimate_paperFC_FF"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace vo
