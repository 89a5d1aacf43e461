#include "tools/studies/pose_pairs.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <Eigen/Geometry>

#include "synth/camera/make_renderer.h"
#include "synth/gltf/scene_file.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/world_geometry.h"
#include "tools/studies/clip.h"
#include "vo/core/error.h"
#include "vo/core/random.h"

namespace tools {
namespace {

Eigen::Vector3d random_direction(vo::Random& random) {
  while (true) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    const Eigen::Vector3d v(x, y, z);
    if (v.norm() > 0.1 && v.norm() <= 1) {
      return v.normalized();
    }
  }
}

/// A view at an eighth of the resolution, which suffices to judge depths and flow.
struct SmallView {
  vo::SE3 T_world_camera;
  vo::DepthImage depth;
  double mean_depth = 0;  ///< m
};

constexpr int kHalvings = 3;

vo::PinholeCamera small_camera(vo::PinholeCamera camera) {
  for (int i = 0; i < kHalvings; ++i) {
    camera = camera.halved();
  }
  return camera;
}

/// Returns a pose in the middle of the lit box, at about eye level, pitched at most 25 deg.
vo::SE3 random_view(const Eigen::AlignedBox3d& box, vo::Random& random) {
  constexpr double kDegree = std::numbers::pi / 180;
  const Eigen::Vector3d eye = box.min() + box.sizes().cwiseProduct(Eigen::Vector3d(
                                              random.uniform(0.25, 0.75), random.uniform(0.4, 0.7),
                                              random.uniform(0.25, 0.75)));
  const double yaw = random.uniform(0, 2 * std::numbers::pi);
  const double pitch = kDegree * random.uniform(-25, 20);
  const double roll = kDegree * random.uniform(-15, 15);
  const Eigen::Vector3d forward(std::cos(yaw) * std::cos(pitch), std::sin(pitch),
                                std::sin(yaw) * std::cos(pitch));
  const vo::SE3 T_view_rolled(Eigen::Quaterniond(Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ())),
                              {0, 0, 0});
  return vo::look_at(eye, eye + forward, Eigen::Vector3d::UnitY()) * T_view_rolled;
}

/// Counts in how many of 4x3 blocks the brightness varies by more than shading alone makes it.
int textured_blocks(const cv::Mat_<cv::Vec3f>& radiance) {
  constexpr int kColumns = 4;
  constexpr int kRows = 3;
  constexpr double kMinContrast = 0.15;  // least standard deviation over mean
  int textured = 0;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const cv::Range rows(radiance.rows * row / kRows, radiance.rows * (row + 1) / kRows);
      const cv::Range columns(radiance.cols * column / kColumns,
                              radiance.cols * (column + 1) / kColumns);
      cv::Scalar mean;
      cv::Scalar deviation;
      cv::meanStdDev(radiance(rows, columns), mean, deviation);
      textured += deviation[1] > kMinContrast * mean[1] ? 1 : 0;
    }
  }
  return textured;
}

SmallView find_view(const synth::Renderer& renderer, const vo::PinholeCamera& camera,
                    const Eigen::AlignedBox3d& box, const PosePairOptions& options,
                    vo::Random& random) {
  constexpr int kAttempts = 1000;
  for (int i = 0; i < kAttempts; ++i) {
    SmallView view{.T_world_camera = random_view(box, random)};
    const synth::RenderedFrame rendered = renderer.render(camera, view.T_world_camera);
    view.depth = rendered.depth;
    double nearest = 0;
    cv::minMaxLoc(view.depth, &nearest);
    view.mean_depth = cv::mean(view.depth)[0];
    if (nearest >= options.min_depth && view.mean_depth >= options.min_mean_depth &&
        textured_blocks(rendered.radiance) >= options.min_textured_blocks) {
      return view;
    }
  }
  vo::fail("pairs: no textured view of the scene in which every pixel has a depth of at least ",
           options.min_depth, " m was found");
}

/// Returns the motion along a twist whose mean flow is `flow_px` pixels at full resolution.
vo::SE3 scaled_motion(const SmallView& view, const vo::PinholeCamera& camera,
                      const vo::Vector6d& twist, double flow_px) {
  constexpr int kIterations = 12;
  const double wanted = flow_px / (1 << kHalvings);
  double scale = wanted / camera.fx;
  for (int i = 0; i < kIterations; ++i) {
    scale *= wanted / mean_flow_px(view.depth, camera, vo::SE3::exp(scale * twist), 1);
  }
  return vo::SE3::exp(scale * twist);
}

}  // namespace

void PosePairOptions::validate() const {
  vo::require(views >= 1, "pairs: expected at least one view, got ", views);
  for (const double flow : flows_px) {
    vo::require(flow > 0, "pairs: expected a flow above 0 px, got ", flow);
  }
}

vo::Trajectory pose_pairs(const synth::Scene& scene, const vo::PinholeCamera& camera,
                          const PosePairOptions& options) {
  options.validate();
  const Eigen::AlignedBox3d box = synth::lit_bounds(synth::flatten(scene));
  vo::require(!box.isEmpty(), "pairs: the scene has no lit surfaces to look at");
  const std::unique_ptr<synth::Renderer> renderer = synth::make_renderer(scene, {.samples = 1});
  const vo::PinholeCamera small = small_camera(camera);
  vo::Random random(options.seed);
  vo::Trajectory poses;
  const auto append = [&](const vo::SE3& T_world_camera) {
    poses.push_back({static_cast<double>(poses.size()), T_world_camera});
  };
  for (int i = 0; i < options.views; ++i) {
    const SmallView view = find_view(*renderer, small, box, options, random);
    append(view.T_world_camera);
    for (const double flow_px : options.flows_px) {
      vo::Vector6d twist;
      const Eigen::Vector3d along = random_direction(random);
      twist << view.mean_depth * along, random_direction(random);
      const vo::SE3 T_cur_ref = scaled_motion(view, small, twist, flow_px);
      append(view.T_world_camera * T_cur_ref.inverse());
    }
  }
  return poses;
}

synth::RenderJob pose_pairs_job(const std::filesystem::path& scene) {
  constexpr int kWidth = 640;           // px
  constexpr int kHeight = 480;          // px
  constexpr double kFocalLength = 525;  // px
  constexpr int kSamples = 9;
  const vo::PinholeCamera camera{
      kWidth, kHeight, kFocalLength, kFocalLength, (kWidth - 1) / 2.0, (kHeight - 1) / 2.0, {}};
  const synth::SceneFile file(scene);
  return {.scene = file,
          .recipe = {.truth = pose_pairs(file.scene(), camera, {}),
                     .camera = vo::RgbdCamera{camera},
                     .render = {.samples = kSamples}}};
}

}  // namespace tools
