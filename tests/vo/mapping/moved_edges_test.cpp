#include "vo/mapping/moved_edges.h"

#include <gtest/gtest.h>

#include "tests/support/instruction_sets.h"
#include "tests/support/plane_map.h"
#include "vo/geometry/projection.h"
#include "vo/mapping/propagate.h"

namespace {

using vo::InstructionSet;
using vo::SE3;

constexpr float kNoise = 0.002F;  // relative

/// The plane's edges at their true depths, and another view of them.
struct TwoViews {
  vo::PinholeCamera camera;
  SE3 T_cur_host = SE3::exp((vo::Vector6d() << 0.1, -0.05, 0.2, 0.02, -0.05, 0.1).finished());
  vo::FramePyramid host;
  vo::FramePyramid current;
  vo::Hypotheses hypotheses;

  explicit TwoViews(const vo::PinholeCamera& lens)
      : camera(lens),
        host(support::grey_frame(lens, SE3())),
        current(support::grey_frame(lens, T_cur_host.inverse())),
        hypotheses(vo::edge_hypotheses(host.levels[0], {}, 0.5F)) {
    for (std::size_t i = 0; i < hypotheses.size(); i += i % 5 == 0 ? 2 : 1) {
      const cv::Vec2f edge = hypotheses.edge_position(i);
      const double d = support::true_inverse_depth(camera, SE3(), edge[0], edge[1]);
      hypotheses.set(i, static_cast<float>(d), static_cast<float>(1e-4 * d * d));
    }
  }

  vo::StereoPair pair() const { return {host.levels[0], current.levels[0], {T_cur_host}}; }
};

std::vector<vo::PinholeCamera> camera_lenses() {
  std::vector<vo::PinholeCamera> cameras(3, support::small_camera());
  cameras[1].distortion = {.k1 = 0.2, .k2 = -0.5, .p1 = -0.003, .p2 = 0.002, .k3 = 0.6};
  cameras[2].distortion = {.k1 = 0.02, .k2 = -0.01, .model = vo::DistortionModel::kannala_brandt};
  return cameras;
}

/// In double precision: the place by the camera, depth and variance by the formula for one edge.
TEST(MovedEdges, AreWhereTheCameraImagesThem) {
  for (const vo::PinholeCamera& camera : camera_lenses()) {
    const TwoViews views(camera);
    const vo::StereoPair pair = views.pair();
    const std::vector<vo::MovedEdge> edges =
        vo::move_edges(pair, views.hypotheses, kNoise, vo::available_instruction_set());
    std::size_t visible = 0;
    std::size_t changed = 0;
    for (const vo::MovedEdge& edge : edges) {
      const std::size_t i = edge.hypothesis;
      const cv::Vec2f at = views.hypotheses.edge_position(i);
      const cv::Vec2f beside = at + views.hypotheses.across[i];
      const double depth = 1.0 / static_cast<double>(views.hypotheses.inverse_depth[i]);
      const Eigen::Vector3d p_host = camera.unproject({at[0], at[1]}, depth);
      const Eigen::Vector3d p_beside = camera.unproject({beside[0], beside[1]}, depth);
      const Eigen::Vector2d pixel = camera.project(views.T_cur_host * p_host);
      const Eigen::Vector2d away = camera.project(views.T_cur_host * p_beside) - pixel;
      EXPECT_LT((edge.position.cast<double>() - pixel).norm(), 0.01) << "px";
      EXPECT_GT(edge.direction.cast<double>().dot(away.normalized()), 0.9999);
      const vo::MovedDepth expected =
          vo::moved_depth(pair, (p_host / depth).head<2>().cast<float>(),
                          views.hypotheses.inverse_depth[i], views.hypotheses.variance[i], kNoise);
      EXPECT_NEAR(edge.inverse_depth, expected.inverse_depth, 1e-5 * expected.inverse_depth);
      EXPECT_NEAR(edge.variance, expected.variance, 1e-4 * expected.variance);
      const vo::SeenBounds bounds(camera.width, camera.height);
      EXPECT_EQ(edge.is_visible, bounds.holds(edge.position.x(), edge.position.y()));
      visible += edge.is_visible ? 1 : 0;
      changed += edge.is_visible && edge.is_changed ? 1 : 0;
    }
    EXPECT_GT(visible, edges.size() / 2);
    EXPECT_LT(visible, edges.size()) << "some leave the image";
    EXPECT_LT(changed, visible / 100) << "the plane looks alike from both sides";
  }
}

TEST(MovedEdges, AreThoseOfWhichSomethingIsKnown) {
  const TwoViews views(support::small_camera());
  const std::vector<vo::MovedEdge> edges =
      vo::move_edges(views.pair(), views.hypotheses, kNoise, vo::available_instruction_set());
  const auto known =
      std::count_if(views.hypotheses.state.begin(), views.hypotheses.state.end(),
                    [](vo::DepthState each) { return each != vo::DepthState::none; });
  EXPECT_EQ(edges.size(), static_cast<std::size_t>(known));
  EXPECT_LT(edges.size(), views.hypotheses.size());
  for (const vo::MovedEdge& edge : edges) {
    EXPECT_NE(views.hypotheses.state[edge.hypothesis], vo::DepthState::none);
  }
}

/// Brighter by all that an image holds; the bound is at most a half of it.
TEST(MovedEdges, TellWhereTheImageShowsSomethingElse) {
  TwoViews views(support::small_camera());
  views.current.levels[0].intensity += 1;
  for (const vo::MovedEdge& edge :
       vo::move_edges(views.pair(), views.hypotheses, kNoise, vo::available_instruction_set())) {
    EXPECT_TRUE(edge.is_changed || !edge.is_visible);
  }
}

TEST(MovedEdges, EveryInstructionSetGivesTheSameBits) {
  for (const vo::PinholeCamera& camera : camera_lenses()) {
    const TwoViews views(camera);
    const std::vector<vo::MovedEdge> expected =
        vo::move_edges(views.pair(), views.hypotheses, kNoise, InstructionSet::baseline);
    for (const InstructionSet set : support::instruction_sets_of_this_machine()) {
      const std::vector<vo::MovedEdge> edges =
          vo::move_edges(views.pair(), views.hypotheses, kNoise, set);
      ASSERT_EQ(edges.size(), expected.size());
      for (std::size_t i = 0; i < edges.size(); ++i) {
        EXPECT_EQ(edges[i].is_visible, expected[i].is_visible);
        EXPECT_EQ(edges[i].is_changed, expected[i].is_changed);
        EXPECT_EQ(edges[i].inverse_depth, expected[i].inverse_depth);
        EXPECT_EQ(edges[i].variance, expected[i].variance);
        EXPECT_EQ(edges[i].position, expected[i].position);
        EXPECT_EQ(edges[i].direction, expected[i].direction);
      }
    }
  }
}

}  // namespace
