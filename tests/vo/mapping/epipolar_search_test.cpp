#include "vo/mapping/epipolar_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/instruction_sets.h"
#include "tests/support/plane_map.h"
#include "tests/support/textured_plane.h"
#include "vo/core/fields.h"

namespace {

using support::small_camera;
using vo::SE3;

/// One found edge: how far off, in units of the place on the line and of its predicted error.
struct Match {
  double error_px = 0;
  double normalized = 0;  ///< error over predicted standard deviation
  double sigma = 0;       ///< predicted, relative
};

/// What is looked for and how.
struct Trial {
  SE3 T_host_cur;
  std::optional<vo::FrameRelation> believed;  ///< where it is not the truth
  float spread = 0.1F;                        ///< of the searched interval, relative to the truth
  double noise = 0;                           ///< grey levels
  vo::EpipolarOptions options;
  double brighter = 0;  ///< offset of the current image, grey levels
};

vo::FramePyramid noisy_frame(const vo::PinholeCamera& camera, const SE3& T_world_camera,
                             double noise, std::uint64_t seed) {
  vo::RgbdFrame image =
      support::with_noise(support::plane_frame(camera, T_world_camera, 0), noise, seed);
  image.depth = vo::DepthImage();
  vo::FramePyramid pyramid = vo::build_pyramid(image, camera, vo::PyramidOptions());
  vo::add_edges(pyramid, vo::EdgeOptions());
  return pyramid;
}

/// The edges of the plane seen from the origin, expected 2 % too near.
std::vector<vo::SearchTarget> targets_of(const vo::PinholeCamera& camera,
                                         const vo::Hypotheses& edges, float spread) {
  std::vector<vo::SearchTarget> targets;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto d = static_cast<float>(
        support::true_inverse_depth(camera, SE3(), edges.pixel[i].x, edges.pixel[i].y));
    targets.push_back({edges.pixel[i], edges.ray[i], edges.gradient[i], d * 1.02F, d * (1 + spread),
                       d * (1 - spread)});
  }
  return targets;
}

/// Looks for all edges of the plane seen from the origin.
std::vector<Match> matches(const vo::PinholeCamera& camera, const Trial& trial) {
  const SE3 T_cur_host = trial.T_host_cur.inverse();
  const vo::FramePyramid host = noisy_frame(camera, SE3(), trial.noise, 7);
  const vo::FramePyramid current = noisy_frame(camera, trial.T_host_cur, trial.noise, 8);
  current.levels[0].intensity += trial.brighter / 255;
  const vo::FrameRelation relation = trial.believed.value_or(vo::FrameRelation{T_cur_host});
  const vo::StereoPair pair(host.levels[0], current.levels[0], relation);
  const vo::Hypotheses edges = vo::edge_hypotheses(host.levels[0], {}, 0.5F);
  const std::vector<vo::SearchTarget> targets = targets_of(camera, edges, trial.spread);
  const std::vector<vo::Observation> observations =
      vo::search_epipolar_lines(pair, trial.options, targets);
  std::vector<Match> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Eigen::Vector2d pixel(edges.pixel[i].x, edges.pixel[i].y);
    const double truth = support::true_inverse_depth(camera, SE3(), pixel.x(), pixel.y());
    const vo::Observation& seen = observations[i];
    if (seen.outcome == vo::SearchOutcome::found) {
      const auto place = [&](double inverse_depth) {
        return camera.project(T_cur_host * camera.unproject(pixel, 1 / inverse_depth));
      };
      const double sign = seen.inverse_depth > truth ? 1 : -1;
      found.push_back({sign * (place(seen.inverse_depth) - place(truth)).norm(),
                       (seen.inverse_depth - truth) / std::sqrt(seen.variance),
                       std::sqrt(seen.variance) / truth});
    }
  }
  return found;
}

template <typename Value>
double mean(const std::vector<Match>& matches, Value value) {
  double sum = 0;
  for (const Match& match : matches) {
    sum += value(match);
  }
  return sum / static_cast<double>(matches.size());
}

const std::vector<SE3>& views() {
  static const std::vector<SE3> poses = {
      SE3(Eigen::Quaterniond::Identity(), {0.06, 0, 0}),
      SE3(Eigen::Quaterniond::Identity(), {0.03, -0.05, 0.02}),
      SE3(Eigen::Quaterniond::Identity(), {0.02, 0.02, 0.12}),
      SE3::exp((vo::Vector6d() << 0.05, 0.02, -0.03, 0.02, -0.03, 0.04).finished())};
  return poses;
}

TEST(EpipolarSearch, IsUnbiasedBelowTwoHundredthsOfAPixel) {
  for (const SE3& T_host_cur : views()) {
    const std::vector<Match> found = matches(small_camera(), {T_host_cur, {}});
    ASSERT_GT(found.size(), 1000U);
    EXPECT_LT(std::abs(mean(found, [](const Match& m) { return m.error_px; })), 0.02)
        << T_host_cur.translation().transpose();
  }
}

/// A brighter current image, as vignette and exposure make it, would move these edges by 0.28 px in
/// the mean if all of it were taken for a displacement.
TEST(EpipolarSearch, IsMovedLittleByABrighterImage) {
  const auto magnitude = [](const Match& m) { return std::abs(m.error_px); };
  const std::vector<Match> same = matches(small_camera(), {views().front(), {}});
  const std::vector<Match> brighter =
      matches(small_camera(),
              {.T_host_cur = views().front(), .believed = {}, .options = {}, .brighter = 8});
  EXPECT_GT(brighter.size(), same.size() * 9 / 10);
  EXPECT_LT(mean(brighter, magnitude), mean(same, magnitude) + 0.15);
}

TEST(EpipolarSearch, FindsTheEdgeInAWideInterval) {
  const std::vector<Match> found = matches(small_camera(), {views()[0], {}, 0.4F});
  ASSERT_GT(found.size(), 1000U);
  const auto wrong = std::count_if(found.begin(), found.end(),
                                   [](const Match& m) { return std::abs(m.error_px) > 1; });
  EXPECT_LT(static_cast<double>(wrong), 0.01 * static_cast<double>(found.size()));
}

/// Normalised squared error of each third of the matches, by predicted error; a good prediction
/// gives 1.
std::array<double, 3> nees_of_thirds(std::vector<Match> found) {
  std::sort(found.begin(), found.end(),
            [](const Match& a, const Match& b) { return a.sigma < b.sigma; });
  const std::size_t third = found.size() / 3;
  std::array<double, 3> nees{};
  for (std::size_t bin = 0; bin < 3; ++bin) {
    const auto begin = found.begin() + static_cast<std::ptrdiff_t>(bin * third);
    const std::vector<Match> part(begin, begin + static_cast<std::ptrdiff_t>(third));
    nees.at(bin) = mean(part, [](const Match& m) { return m.normalized * m.normalized; });
  }
  return nees;
}

/// Noise of 4 grey levels and no error of the line: what is left is the photometric term, and 0.02
/// px of interpolation. The brightness changes by nothing here, for which a part of the variance
/// allows.
TEST(EpipolarSearch, PredictsWhatNoiseDoes) {
  const vo::EpipolarOptions options{.sigma_line_px = 0, .sigma_match_px = 0.02, .sigma_grey = 4};
  std::vector<Match> found;
  for (const SE3& T_host_cur : views()) {
    const std::vector<Match> some = matches(small_camera(), {T_host_cur, {}, 0.1F, 4, options});
    found.insert(found.end(), some.begin(), some.end());
  }
  for (const double nees : nees_of_thirds(found)) {
    EXPECT_GT(nees, 0.35);
    EXPECT_LT(nees, 1.4);
  }
}

/// Poses that are off as their covariance says, twenty times; no other error.
TEST(EpipolarSearch, PredictsWhatAWrongPoseDoes) {
  const vo::EpipolarOptions options{.sigma_line_px = 0, .sigma_match_px = 0.02, .sigma_grey = 1};
  vo::Vector6d sigma;
  sigma << 1e-3, 1e-3, 1e-3, 3e-4, 3e-4, 3e-4;
  std::vector<Match> found;
  for (std::uint64_t trial = 0; trial < 20; ++trial) {
    vo::Vector6d error;
    for (int k = 0; k < 6; ++k) {
      error[k] = sigma[k] * support::hash_noise(6 * trial + static_cast<std::uint64_t>(k));
    }
    const SE3 T_cur_host = SE3::exp(error) * views()[3].inverse();
    vo::FrameRelation believed{T_cur_host};
    believed.covariance = sigma.cwiseAbs2().asDiagonal();
    const std::vector<Match> some =
        matches(small_camera(), {views()[3], believed, 0.1F, 0, options});
    found.insert(found.end(), some.begin(), some.end());
  }
  for (const double nees : nees_of_thirds(found)) {
    EXPECT_GT(nees, 0.5);
    EXPECT_LT(nees, 2);
  }
}

/// Two frames and what is looked for, from well known to unknown.
struct Search {
  vo::FramePyramid host;
  vo::FramePyramid current;
  vo::FrameRelation relation;
  std::vector<vo::SearchTarget> targets;

  explicit Search(const vo::PinholeCamera& camera)
      : host(noisy_frame(camera, SE3(), 2, 7)),
        current(noisy_frame(camera, views()[3], 2, 8)),
        relation{views()[3].inverse()} {
    relation.covariance = vo::Matrix6d::Identity() * 1e-6;
    const vo::Hypotheses edges = vo::edge_hypotheses(host.levels[0], {}, 0.5F);
    const std::vector<vo::SearchTarget> known = targets_of(camera, edges, 0.02F);
    const std::vector<vo::SearchTarget> unknown = targets_of(camera, edges, 0.8F);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      targets.push_back(i % 3 == 0 ? unknown[i] : known[i]);
    }
  }

  std::vector<vo::Observation> observe(std::span<const vo::SearchTarget> some,
                                       vo::InstructionSet set) const {
    const vo::StereoPair pair(host.levels[0], current.levels[0], relation);
    return vo::search_epipolar_lines(pair, {}, some, set);
  }
};

std::vector<vo::PinholeCamera> lenses() {
  std::vector<vo::PinholeCamera> cameras(3, small_camera());
  cameras[1].distortion = {.k1 = 0.2, .k2 = -0.5, .p1 = -0.003, .p2 = 0.002, .k3 = 0.6};
  cameras[2].distortion = {.k1 = 0.02, .k2 = -0.01, .model = vo::DistortionModel::kannala_brandt};
  return cameras;
}

void expect_same(const vo::Observation& a, const vo::Observation& b) {
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.inverse_depth, b.inverse_depth);
  EXPECT_EQ(a.variance, b.variance);
  EXPECT_EQ(a.offset_slope, b.offset_slope);
}

TEST(EpipolarSearch, EveryInstructionSetGivesTheSameBits) {
  for (const vo::PinholeCamera& camera : lenses()) {
    for (const float motion : {0.0F, 0.01F}) {
      Search search(camera);
      search.relation.host_motion.angular = {motion, -motion, 2 * motion};
      search.relation.current_motion.linear = {motion, 0, -motion};
      const std::vector<vo::Observation> expected =
          search.observe(search.targets, vo::InstructionSet::baseline);
      for (const vo::SearchOutcome outcome :
           {vo::SearchOutcome::found, vo::SearchOutcome::unobservable,
            vo::SearchOutcome::no_match}) {
        EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [&](const vo::Observation& o) {
          return o.outcome == outcome;
        })) << static_cast<int>(outcome);
      }
      for (const vo::InstructionSet set : support::instruction_sets_of_this_machine()) {
        const std::vector<vo::Observation> observations = search.observe(search.targets, set);
        for (std::size_t i = 0; i < expected.size(); ++i) {
          expect_same(observations[i], expected[i]);
        }
      }
    }
  }
}

TEST(EpipolarSearch, AnEdgeIsFoundAloneAsAmongOthers) {
  const Search search(lenses()[1]);
  const vo::InstructionSet set = vo::available_instruction_set();
  const std::vector<vo::Observation> together = search.observe(search.targets, set);
  for (std::size_t i = 0; i < together.size(); i += 7) {
    expect_same(search.observe({&search.targets[i], 1}, set).front(), together[i]);
  }
  EXPECT_TRUE(search.observe({}, set).empty());
}

/// A camera that moves steadily and reads its lines one after the other.
struct RollingCamera {
  vo::PinholeCamera camera = small_camera();
  vo::Vector6d velocity = (vo::Vector6d() << 0.3, -0.1, 0.05, 0.1, 0.3, -0.4).finished();
  vo::Readout readout{.seconds = 0.02};

  SE3 T_world_line(double time, int line) const {
    const int lines = readout.axis == vo::ReadoutAxis::rows ? camera.height : camera.width;
    return SE3::exp(velocity * (time + readout.seconds * ((line + 0.5) / lines - 0.5)));
  }

  vo::FramePyramid frame(double time) const {
    vo::RgbdFrame image = support::TexturedPlane().render_lines(
        camera, readout.axis, [&](int line) { return T_world_line(time, line); }, time);
    image.depth = vo::DepthImage();
    vo::FramePyramid pyramid = vo::build_pyramid(image, camera, vo::PyramidOptions());
    vo::add_edges(pyramid, vo::EdgeOptions());
    return pyramid;
  }
};

/// Returns the median relative error of the depths found between two frames 0.2 s apart.
double median_error(const RollingCamera& rolling, const vo::ReadoutMotion& believed) {
  constexpr double kSeconds = 0.2;
  const vo::FramePyramid host = rolling.frame(0);
  const vo::FramePyramid current = rolling.frame(kSeconds);
  vo::FrameRelation relation{SE3::exp(-kSeconds * rolling.velocity)};
  relation.host_motion = relation.current_motion = believed;
  const vo::Hypotheses edges = vo::edge_hypotheses(host.levels[0], {}, 0.5F);
  std::vector<vo::SearchTarget> targets;
  std::vector<double> truth;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const cv::Point pixel = edges.pixel[i];
    const int line = rolling.readout.axis == vo::ReadoutAxis::rows ? pixel.y : pixel.x;
    truth.push_back(support::true_inverse_depth(rolling.camera, rolling.T_world_line(0, line),
                                                pixel.x, pixel.y));
    const auto d = static_cast<float>(truth.back());
    targets.push_back({pixel, edges.ray[i], edges.gradient[i], 1.02F * d, 1.1F * d, 0.9F * d});
  }
  const vo::StereoPair pair(host.levels[0], current.levels[0], relation);
  const std::vector<vo::Observation> seen = vo::search_epipolar_lines(pair, {}, targets);
  std::vector<double> errors;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].outcome == vo::SearchOutcome::found) {
      errors.push_back(seen[i].inverse_depth / truth[i] - 1);
    }
  }
  EXPECT_GT(errors.size(), 500U);
  return support::median_magnitude(errors);
}

TEST(EpipolarSearch, FindsDepthsFromLineToLine) {
  for (const vo::ReadoutAxis axis : {vo::ReadoutAxis::rows, vo::ReadoutAxis::columns}) {
    for (const double seconds : {0.02, -0.02}) {
      const RollingCamera rolling{.readout = {seconds, axis}};
      const double known =
          median_error(rolling, vo::ReadoutMotion(rolling.velocity, rolling.readout));
      EXPECT_LT(known, 0.005) << vo::to_string(axis) << " in " << seconds << " s";
      EXPECT_LT(known, 0.3 * median_error(rolling, {})) << vo::to_string(axis);
    }
  }
}

TEST(EpipolarSearch, SaysNothingWithoutParallax) {
  const SE3 turn = SE3::exp((vo::Vector6d() << 0, 0, 0, 0.01, 0.02, 0.03).finished());
  EXPECT_TRUE(matches(small_camera(), {turn, {}}).empty());
}

TEST(EpipolarSearch, KnowsTheLens) {
  vo::PinholeCamera camera = small_camera();
  camera.distortion = {.k1 = 0.2, .k2 = -0.5, .p1 = -0.003, .p2 = 0.002, .k3 = 0.6};
  const std::vector<Match> found = matches(camera, {views()[3], {}});
  ASSERT_GT(found.size(), 1000U);
  EXPECT_LT(std::abs(mean(found, [](const Match& m) { return m.error_px; })), 0.02);
}

}  // namespace
