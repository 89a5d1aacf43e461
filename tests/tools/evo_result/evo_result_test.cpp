#include "tools/evo_result/evo_result.h"

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/example_trajectory.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The bytes of a file of an archive that is not compressed, by the name before them.
std::string file_in(const std::string& archive, const std::string& name) {
  const std::size_t at = archive.find(name);
  std::uint32_t size = 0;
  std::memcpy(&size, archive.data() + at - 8, sizeof(size));
  return archive.substr(at + name.size(), size);
}

/// The numbers of an .npy file of '<f8'.
std::vector<double> numbers_in(const std::string& archive, const std::string& name) {
  const std::string file = file_in(archive, name + ".npy");
  const std::size_t begin = file.find('\n') + 1;
  std::vector<double> numbers((file.size() - begin) / sizeof(double));
  std::memcpy(numbers.data(), file.data() + begin, numbers.size() * sizeof(double));
  return numbers;
}

/// A trajectory, and the same one turned, moved and half as large.
class EvoResult : public testing::Test {
 protected:
  vo::Trajectory truth = support::example_trajectory(20, 10, 100);
  vo::SE3 T_own_world = support::example_pose(3.3);
  vo::Trajectory estimate = support::moved(T_own_world, truth);

  void halve() {
    for (vo::StampedPose& pose : estimate) {
      pose.T_world_camera = {pose.T_world_camera.rotation(),
                             0.5 * pose.T_world_camera.translation()};
    }
  }

  std::string encode(vo::TrajectoryAlignment alignment) const {
    return tools::encode_evo_ape({truth, estimate, "gt.txt", "e \"1\".txt"},
                                 {.alignment = alignment});
  }
};

TEST_F(EvoResult, HasEvosNamesTitleAndLabel) {
  const json info = json::parse(file_in(encode(vo::TrajectoryAlignment::se3), "info.json"));
  EXPECT_EQ(info,
            (json{{"title", "APE w.r.t. translation part (m)\n(with SE(3) Umeyama alignment)"},
                  {"ref_name", "gt.txt"},
                  {"est_name", "e \"1\".txt"},
                  {"label", "APE (m)"}}));
  EXPECT_THAT(file_in(encode(vo::TrajectoryAlignment::none), "info.json"),
              HasSubstr("(not aligned)"));
}

TEST_F(EvoResult, TheAlignmentIsTheSimilarityFromEstimateToTruth) {
  halve();
  const std::string archive = encode(vo::TrajectoryAlignment::sim3);
  const std::vector<double> m = numbers_in(archive, "alignment_transformation_sim3");
  ASSERT_EQ(m.size(), 16U);
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> S(m.data());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d moved =
        (S * estimate[i].T_world_camera.translation().homogeneous()).head<3>();
    EXPECT_LT((moved - truth[i].T_world_camera.translation()).norm(), 1e-9);
  }
  for (const double error : numbers_in(archive, "error_array")) {
    EXPECT_LT(error, 1e-9);
  }
}

TEST_F(EvoResult, DistancesAreAlongTheTruthAndTheAlignedEstimate) {
  const std::string archive = encode(vo::TrajectoryAlignment::se3);
  EXPECT_NEAR(numbers_in(archive, "distances_from_start").back(), vo::path_length(truth), 1e-9);
  EXPECT_NEAR(numbers_in(archive, "distances").back(), vo::path_length(truth), 1e-9);
  EXPECT_EQ(numbers_in(archive, "distances").front(), 0);
  EXPECT_NEAR(numbers_in(archive, "seconds_from_start").back(), 1.9, 1e-9);
  EXPECT_NEAR(numbers_in(archive, "timestamps").front(), 100, 1e-9);
}

TEST_F(EvoResult, StatisticsAreOfTheErrorsWithoutAlignment) {
  for (vo::StampedPose& pose : estimate) {
    pose.T_world_camera = truth[static_cast<std::size_t>(&pose - estimate.data())].T_world_camera;
  }
  estimate[0].T_world_camera = {
      estimate[0].T_world_camera.rotation(),
      estimate[0].T_world_camera.translation() + Eigen::Vector3d(0, 3, 4)};
  const std::string archive = encode(vo::TrajectoryAlignment::none);
  const json stats = json::parse(file_in(archive, "stats.json"));
  EXPECT_NEAR(stats["sse"], 25, 1e-9);
  EXPECT_NEAR(stats["rmse"], std::sqrt(25.0 / 20), 1e-9);
  EXPECT_NEAR(stats["mean"], 0.25, 1e-9);
  EXPECT_NEAR(stats["std"], std::sqrt(25.0 / 20 - 0.25 * 0.25), 1e-9);
  EXPECT_NEAR(stats["max"], 5, 1e-9);
  EXPECT_NEAR(stats["min"], 0, 1e-9);
  EXPECT_NEAR(stats["median"], 0, 1e-9);
  EXPECT_EQ(archive.find("alignment_transformation"), std::string::npos);
}

}  // namespace
