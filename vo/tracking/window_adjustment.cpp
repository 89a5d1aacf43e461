#include "vo/tracking/window_adjustment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vo/alignment/host_system.h"
#include "vo/core/damped_descent.h"
#include "vo/core/error.h"
#include "vo/core/normal_equations.h"
#include "vo/residuals/linearize.h"

namespace vo {
namespace {

constexpr Eigen::Index kPose = 6;

/// The indices of a host frame, whose points are used, and of the target they are looked up in.
struct WindowPair {
  std::size_t host;
  std::size_t target;
};

/// All quantities that are adjusted.
struct WindowState {
  std::vector<SE3> T_frame_world;
  std::vector<Eigen::VectorXd> inverse_depth;  ///< 1/m, one vector per host frame
  std::vector<ResidualModel> models;           ///< one per pair

  SE3 T_target_host(const WindowPair& pair) const {
    return T_frame_world[pair.target] * T_frame_world[pair.host].inverse();
  }
};

Eigen::VectorXd inverses(const std::vector<float>& depth) {
  return Eigen::Map<const Eigen::VectorXf>(depth.data(), static_cast<Eigen::Index>(depth.size()))
      .cast<double>()
      .cwiseInverse();
}

EdgePointLevel at_inverse_depths(const EdgePointLevel& points, const Eigen::VectorXd& inverse) {
  const Eigen::VectorXf depth = inverse.cwiseInverse().cast<float>();
  return at_depths(points, {depth.begin(), depth.end()});
}

double visible_fraction(const PointView& view) {
  const std::vector<float> seen = sampled_intensities(view);
  const auto hidden =
      std::count_if(seen.begin(), seen.end(), [](float value) { return std::isnan(value); });
  return seen.empty() ? 0 : 1 - static_cast<double>(hidden) / static_cast<double>(seen.size());
}

/// Returns the brightness and the scale that a pair's images show, estimated alternately.
ResidualModel shown_model(const PointView& view, const AlignOptions& options) {
  constexpr int kRounds = 3;
  ResidualModel model{options.loss_scale, {}};
  const bool affine = options.brightness == BrightnessModel::affine;
  if (affine) {
    model.brightness = matched_brightness(view);
  }
  for (int round = 0; round < kRounds; ++round) {
    if (options.scale == LossScale::residuals) {
      model.scale = shown_scale(view, model.brightness, options);
    }
    if (affine) {
      const Eigen::Vector2d step =
          linearize(view, options, model).trailing<kBrightnessParameters>().step();
      model.brightness.gain += step[0];
      model.brightness.offset += step[1];
    }
  }
  return model;
}

/// The frames and the pairs of them that see enough of each other.
class Window {
 public:
  Window(const std::vector<WindowFrame>& frames, const WindowOptions& window,
         const AlignOptions& options)
      : frames_(frames), window_(window), options_(options), pairs_of_(frames.size()) {
    start_.inverse_depth.resize(frames.size());
    for (const WindowFrame& frame : frames) {
      start_.T_frame_world.push_back(frame.T_frame_world);
    }
    for (std::size_t host = 0; host < frames.size(); ++host) {
      start_.inverse_depth[host] = inverses(frames[host].points.z_ref);
      for (std::size_t target = 0; target < frames.size(); ++target) {
        add_pair({host, target});
      }
      if (!pairs_of_[host].empty()) {
        hosts_.push_back(host);
      }
    }
  }

  const WindowState& start() const { return start_; }

  double loss(const WindowState& state) const {
    double sum = 0;
    for (const std::size_t host : hosts_) {
      const EdgePointLevel points = points_of(host, state);
      for (const std::size_t p : pairs_of_[host]) {
        const ResidualModel& model = state.models[p];
        sum += linearize(view(pairs_[p], points, state), options_, model).cost /
               (model.scale * model.scale);
      }
      if (adjusts_depth()) {
        sum += information(host).dot(strayed(host, state).cwiseAbs2());
      }
    }
    return sum;
  }

  /// Returns the state that a damped step from `state` leads to.
  WindowState stepped(const WindowState& state, double damping) const {
    std::vector<HostSystem> systems;
    auto equations = NormalEquations<Eigen::Dynamic>::zero(pose_rows());
    for (const std::size_t host : hosts_) {
      systems.push_back(system_of(host, state));
      equations.add(systems.back().increments(), increment_jacobian(host, state));
    }
    hold_poses(equations);
    equations.H.diagonal() *= 1 + damping;
    return moved(state, systems, equations.step());
  }

 private:
  bool adjusts_depth() const { return window_.adjust == WindowAdjustment::depth; }
  Eigen::Index pose_rows() const { return kPose * static_cast<Eigen::Index>(frames_.size()); }

  void add_pair(const WindowPair& pair) {
    const WindowFrame& host = frames_[pair.host];
    const bool says_something = !host.held || !frames_[pair.target].held || adjusts_depth();
    if (pair.host == pair.target || !says_something) {
      return;
    }
    const PointView seen = view(pair, host.points, start_);
    if (visible_fraction(seen) >= window_.min_overlap) {
      pairs_of_[pair.host].push_back(pairs_.size());
      pairs_.push_back(pair);
      start_.models.push_back(shown_model(seen, options_));
    }
  }

  EdgePointLevel points_of(std::size_t host, const WindowState& state) const {
    return adjusts_depth() ? at_inverse_depths(frames_[host].points, state.inverse_depth[host])
                           : frames_[host].points;
  }

  PointView view(const WindowPair& pair, const EdgePointLevel& points,
                 const WindowState& state) const {
    return {points, *frames_[pair.target].image, state.T_target_host(pair),
            ReadoutMotion(frames_[pair.host].velocity.twist, options_.readout),
            ReadoutMotion(frames_[pair.target].velocity.twist, options_.readout)};
  }

  /// Returns the inverse variance of the measured inverse depths, m^2.
  Eigen::VectorXd information(std::size_t host) const {
    const WindowFrame& frame = frames_[host];
    Eigen::VectorXd result(static_cast<Eigen::Index>(frame.points.size()));
    for (Eigen::Index i = 0; i < result.size(); ++i) {
      const double z = frame.measured_depth[static_cast<std::size_t>(i)];
      const double sigma =
          window_.depth_noise * frame.points.depth_sigma[static_cast<std::size_t>(i)] / (z * z);
      result[i] = 1 / (sigma * sigma);
    }
    return result;
  }

  Eigen::VectorXd strayed(std::size_t host, const WindowState& state) const {
    return state.inverse_depth[host] - inverses(frames_[host].measured_depth);
  }

  HostSystem system_of(std::size_t host, const WindowState& state) const {
    const EdgePointLevel points = points_of(host, state);
    const std::vector<std::size_t>& pairs = pairs_of_[host];
    HostSystem system(options_, pairs.size(), adjusts_depth() ? points.size() : 0);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      system.add(k, view(pairs_[pairs[k]], points, state), state.models[pairs[k]]);
    }
    if (adjusts_depth()) {
      system.hold_depth(information(host), strayed(host, state));
    }
    return system;
  }

  /// Returns d(increments of the host's pairs) / d(increments left of all T_frame_world).
  Eigen::MatrixXd increment_jacobian(std::size_t host, const WindowState& state) const {
    const std::vector<std::size_t>& pairs = pairs_of_[host];
    Eigen::MatrixXd J =
        Eigen::MatrixXd::Zero(kPose * static_cast<Eigen::Index>(pairs.size()), pose_rows());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const WindowPair& pair = pairs_[pairs[k]];
      const Eigen::Index row = kPose * static_cast<Eigen::Index>(k);
      J.block<kPose, kPose>(row, kPose * static_cast<Eigen::Index>(pair.target)).setIdentity();
      J.block<kPose, kPose>(row, kPose * static_cast<Eigen::Index>(host)) =
          -adjoint(state.T_target_host(pair));
    }
    return J;
  }

  void hold_poses(NormalEquations<Eigen::Dynamic>& equations) const {
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      if (frames_[f].held) {
        const Eigen::Index at = kPose * static_cast<Eigen::Index>(f);
        equations.H.middleRows<kPose>(at).setZero();
        equations.H.middleCols<kPose>(at).setZero();
        equations.H.block<kPose, kPose>(at, at).setIdentity();
        equations.b.segment<kPose>(at).setZero();
      }
    }
  }

  WindowState moved(const WindowState& state, const std::vector<HostSystem>& systems,
                    const Eigen::VectorXd& delta) const {
    WindowState next = state;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const Vector6d increment = delta.segment<kPose>(kPose * static_cast<Eigen::Index>(f));
      next.T_frame_world[f] = SE3::exp(increment) * state.T_frame_world[f];
    }
    for (std::size_t h = 0; h < hosts_.size(); ++h) {
      const Eigen::VectorXd increments = increment_jacobian(hosts_[h], state) * delta;
      move_points(hosts_[h], systems[h].step_with(increments), next);
    }
    return next;
  }

  void move_points(std::size_t host, const HostSystem::Step& step, WindowState& next) const {
    constexpr double kMaxChange = 0.3;  // share of an inverse depth, in one step
    for (std::size_t k = 0; k < pairs_of_[host].size(); ++k) {
      Brightness& brightness = next.models[pairs_of_[host][k]].brightness;
      brightness.gain += step.brightness[2 * static_cast<Eigen::Index>(k)];
      brightness.offset += step.brightness[2 * static_cast<Eigen::Index>(k) + 1];
    }
    if (adjusts_depth()) {
      const Eigen::VectorXd limit = kMaxChange * next.inverse_depth[host];
      next.inverse_depth[host] += step.inverse_depth.cwiseMin(limit).cwiseMax(-limit);
    }
  }

  const std::vector<WindowFrame>& frames_;
  const WindowOptions& window_;
  const AlignOptions& options_;
  std::vector<WindowPair> pairs_;
  std::vector<std::vector<std::size_t>> pairs_of_;  ///< indices of the pairs of each host frame
  std::vector<std::size_t> hosts_;                  ///< frames that host a pair
  WindowState start_;
};

}  // namespace

void WindowOptions::validate() const {
  constexpr auto kMost = static_cast<int>(kMaxWindow / 2);
  require(moved >= 1 && moved <= kMost, "window.moved: expected 1 to ", kMost, ", got ", moved);
  require(held >= 1 && held <= kMost, "window.held: expected 1 to ", kMost, ", got ", held);
  require(max_iterations >= 1, "window.max_iterations: expected at least 1, got ", max_iterations);
  require(min_overlap >= 0 && min_overlap <= 1, "window.min_overlap: expected 0 to 1, got ",
          min_overlap);
  require(converged >= 0, "window.converged: expected at least 0, got ", converged);
  require(depth_noise > 0, "window.depth_noise: expected above 0, got ", depth_noise);
}

EdgePointLevel at_depths(const EdgePointLevel& points, const std::vector<float>& depth) {
  EdgePointLevel result = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float factor = depth[i] / points.z_ref[i];
    result.x_ref[i] *= factor;
    result.y_ref[i] *= factor;
    result.z_ref[i] = depth[i];
    for (std::vector<float>* slope : {&result.dI_dx, &result.dI_dy, &result.dI_dz}) {
      (*slope)[i] /= factor;
    }
  }
  return result;
}

void adjust_window(std::vector<WindowFrame>& frames, const WindowOptions& window,
                   const AlignOptions& options) {
  const Window problem(frames, window, options);
  WindowState state = problem.start();
  descend(
      state,
      [&](const WindowState& from, double damping) { return problem.stepped(from, damping); },
      [&](const WindowState& at) { return problem.loss(at); },
      {.iterations = window.max_iterations, .converged = window.converged});
  for (std::size_t f = 0; f < frames.size(); ++f) {
    frames[f].T_frame_world = state.T_frame_world[f];
    if (window.adjust == WindowAdjustment::depth) {
      frames[f].points = at_inverse_depths(frames[f].points, state.inverse_depth[f]);
    }
  }
}

}  // namespace vo
