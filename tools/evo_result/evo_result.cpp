#include "tools/evo_result/evo_result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "vo/archives/zip.h"
#include "vo/geometry/associate.h"
#include "vo/image_files/npy.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;
using Matrix4dByRows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

/// The poses of an evaluation that belong together, with equal indices.
struct MatchedPoses {
  vo::Trajectory truth;
  vo::Trajectory estimate;  ///< aligned
};

MatchedPoses matched_poses(const EvaluatedTrajectories& trajectories, const vo::Trajectory& aligned,
                           const vo::EvaluationOptions& options) {
  MatchedPoses matched;
  for (const auto& [i, j] :
       vo::associate(vo::timestamps_of(trajectories.truth),
                     vo::timestamps_of(trajectories.estimate, options.time_offset),
                     options.max_time_difference)) {
    matched.truth.push_back(trajectories.truth[i]);
    matched.estimate.push_back(aligned[j]);
  }
  return matched;
}

/// Returns the length of the path from the first pose to each, m.
std::vector<double> distances_along(const vo::Trajectory& trajectory) {
  std::vector<double> distances(1, 0);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    distances.push_back(distances.back() + (trajectory[i].T_world_camera.translation() -
                                            trajectory[i - 1].T_world_camera.translation())
                                               .norm());
  }
  return distances;
}

/// Returns the similarity, of this scale, that took a pose to where it is aligned.
Matrix4dByRows similarity(const vo::SE3& pose, const vo::SE3& aligned, double scale) {
  const Eigen::Matrix3d R = aligned.rotation_matrix() * pose.rotation_matrix().transpose();
  Matrix4dByRows matrix = Matrix4dByRows::Identity();
  matrix.topLeftCorner<3, 3>() = scale * R;
  matrix.topRightCorner<3, 1>() = aligned.translation() - scale * R * pose.translation();
  return matrix;
}

Json statistics(std::span<const double> errors) {
  const vo::Statistics all = vo::summarize(errors);
  double square_sum = 0;
  double deviation = 0;
  for (const double error : errors) {
    square_sum += error * error;
    deviation += (error - all.mean) * (error - all.mean);
  }
  return {{"rmse", all.rmse},
          {"mean", all.mean},
          {"median", all.median},
          {"std", std::sqrt(deviation / static_cast<double>(errors.size()))},
          {"min", *std::min_element(errors.begin(), errors.end())},
          {"max", all.max},
          {"sse", square_sum}};
}

const char* describe(vo::TrajectoryAlignment alignment) {
  switch (alignment) {
    case vo::TrajectoryAlignment::none:
      return "(not aligned)";
    case vo::TrajectoryAlignment::se3:
      return "(with SE(3) Umeyama alignment)";
    case vo::TrajectoryAlignment::sim3:
      return "(with Sim(3) Umeyama alignment)";
  }
  return "";
}

Json information(const EvaluatedTrajectories& trajectories, vo::TrajectoryAlignment alignment) {
  return {{"title", std::string("APE w.r.t. translation part (m)\n") + describe(alignment)},
          {"ref_name", trajectories.truth_name},
          {"est_name", trajectories.estimate_name},
          {"label", "APE (m)"}};
}

vo::NamedBytes json_file(const std::string& name, const Json& json) {
  return {name + ".json", json.dump(-1, ' ', true, Json::error_handler_t::replace)};
}

vo::NamedBytes array_file(const std::string& name, const std::vector<double>& values) {
  return {name + ".npy", vo::encode_npy(values, std::array{values.size()})};
}

}  // namespace

std::string encode_evo_ape(const EvaluatedTrajectories& trajectories,
                           const vo::EvaluationOptions& options) {
  const vo::TrajectoryErrors errors =
      vo::evaluate(trajectories.truth, trajectories.estimate, options);
  const vo::ErrorsOverTime over_time =
      vo::errors_over_time(trajectories.truth, trajectories.estimate, options);
  const std::optional<vo::Trajectory> aligned =
      vo::align_trajectory(trajectories.truth, trajectories.estimate, options);
  const MatchedPoses matched = matched_poses(trajectories, aligned.value(), options);
  std::vector<double> seconds = over_time.timestamps;
  for (double& second : seconds) {
    second -= over_time.timestamps.front();
  }
  std::vector<vo::NamedBytes> files = {
      json_file("info", information(trajectories, options.alignment)),
      json_file("stats", statistics(over_time.ate)),
      array_file("error_array", over_time.ate),
      array_file("seconds_from_start", seconds),
      array_file("timestamps", over_time.timestamps),
      array_file("distances_from_start", distances_along(matched.truth)),
      array_file("distances", distances_along(matched.estimate))};
  if (options.alignment != vo::TrajectoryAlignment::none) {
    const Matrix4dByRows matrix = similarity(trajectories.estimate.front().T_world_camera,
                                             aligned->front().T_world_camera, errors.scale);
    files.push_back({"alignment_transformation_sim3.npy",
                     vo::encode_npy({matrix.data(), 16}, std::array<std::size_t, 2>{4, 4})});
  }
  return vo::zip(files);
}

}  // namespace tools
