#include "vo/mapping/epipolar_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {
namespace {

constexpr int kReach = 2;  // samples to either side that are compared
constexpr int kCompared = 2 * kReach + 1;
constexpr int kSampled = kCompared + 2;  // and one more for differences
constexpr float kGreyLevel = 1.0F / 255;
constexpr float kUnseen = 1e9F;  // squared difference of what is out of the image

/// Direction of the epipolar line in the anchor, in ray coordinates: towards where nearer points
/// of the pixel's ray go.
Eigen::Vector2f line_direction(const StereoPair& pair, const Eigen::Vector2f& ray) {
  const Eigen::Vector3f& c = pair.p_anchor_cur;
  return {c.x() - c.z() * ray.x(), c.y() - c.z() * ray.y()};
}

Eigen::Vector2f ray_of(const PyramidLevel& level, cv::Point pixel) {
  const cv::Vec2f& ray = level.rays(pixel);
  return {ray[0], ray[1]};
}

/// Pixels along a line near one place on it; exact where the lens is perfect.
struct LinePixels {
  Eigen::Vector2f pixel;
  Eigen::Vector2f direction;
  float start;

  LinePixels(const ImagedRay& imaged, const Eigen::Vector2f& dq_ds, float s)
      : pixel(imaged.pixel), direction(imaged.J * dq_ds), start(s) {}

  Eigen::Vector2f at(float s) const { return pixel + (s - start) * direction; }

  /// A straight line is inside where its ends are.
  bool can_be_sampled(const GrayImage& image, float first, float last) const {
    return vo::can_be_sampled(image, at(first)) && vo::can_be_sampled(image, at(last));
  }
};

}  // namespace

/// The epipolar line of one pixel in the current image around its expected place, s = 0, and what
/// the anchor shows along its own.
struct EpipolarSearch::Line {
  Eigen::Vector2f along_anchor;  ///< px, unit, of the line in the anchor
  Eigen::Vector3f R_ray;         ///< R ray: the point at inverse depth d is along R_ray + d t
  Eigen::Vector2f q;             ///< ray coordinates of the expected place
  Eigen::Vector2f dq_ds;         ///< of one px along the line
  ImagedRay imaged;              ///< of q
  float step = 1;                ///< px per sample of the anchor
  float s_min = 0;               ///< px
  float s_max = 0;               ///< px
  float cosine = 1;              ///< of gradient and line
  float sine = 0;
  std::array<float, kSampled> anchor{};  ///< intensities as the current image should show them
};

/// What the comparison at the best place says.
struct EpipolarSearch::Fit {
  float information = 0;  ///< sum of squared slopes, per px^2
  float squares = 0;      ///< sum of squared differences
};

float epipolar_cos2(const StereoPair& pair, cv::Point pixel, const cv::Vec2f& gradient) {
  const Eigen::Vector2f ray = ray_of(pair.anchor, pixel);
  const Eigen::Vector2f line = image_ray(pair.anchor.camera, ray).J * line_direction(pair, ray);
  const float along = gradient[0] * line.x() + gradient[1] * line.y();
  const float norm2 = line.squaredNorm() * (gradient[0] * gradient[0] + gradient[1] * gradient[1]);
  return norm2 > 0 ? along * along / norm2 : 0;
}

/// False where the pixel tells nothing: no parallax, no gradient along the line, another scale.
bool EpipolarSearch::make_line(const SearchTarget& target, Line& line) const {
  const Eigen::Vector2f ray = ray_of(pair_.anchor, target.pixel);
  const Eigen::Vector2f towards = line_direction(pair_, ray);
  const Eigen::Vector2f towards_px = image_ray(pair_.anchor.camera, ray).J * towards;
  const float length_px = towards_px.norm();
  if (!(length_px * target.inverse_depth >= static_cast<float>(options_.min_parallax_px))) {
    return false;
  }
  const Eigen::Vector2f along = towards_px / length_px;
  line.along_anchor = along;
  const float gradient_along = target.gradient[0] * along.x() + target.gradient[1] * along.y();
  const float norm = std::hypot(target.gradient[0], target.gradient[1]);
  line.cosine = gradient_along / norm;
  line.sine = (along.x() * target.gradient[1] - along.y() * target.gradient[0]) / norm;
  if (2 * std::abs(gradient_along) < static_cast<float>(options_.min_gradient) * kGreyLevel ||
      line.cosine * line.cosine < static_cast<float>(options_.min_cos2)) {
    return false;
  }
  line.R_ray = pair_.R_cur_anchor * ray.homogeneous();
  const Eigen::Vector3f P = line.R_ray + target.inverse_depth * pair_.t_cur_anchor;
  const Eigen::Vector2f neighbour = ray + towards / length_px;
  const Eigen::Vector3f next =
      pair_.R_cur_anchor * neighbour.homogeneous() + target.inverse_depth * pair_.t_cur_anchor;
  if (!(P.z() > 0.1F && next.z() > 0.1F)) {
    return false;
  }
  line.q = P.hnormalized();
  const Eigen::Vector2f step_q = next.hnormalized() - line.q;
  line.imaged = image_ray(pair_.current.camera, line.q);
  line.step = (line.imaged.J * step_q).norm();
  const auto limit = static_cast<float>(options_.max_scale_change);
  if (!(line.step * limit >= 1 && line.step <= limit)) {
    return false;
  }
  line.dq_ds = step_q / line.step;
  return true;
}

/// False where the samples leave the anchor. Also finds the ends of the searched interval.
bool EpipolarSearch::sample_anchor(const SearchTarget& target, Line& line) const {
  const Eigen::Vector2f centre(static_cast<float>(target.pixel.x),
                               static_cast<float>(target.pixel.y));
  const Eigen::Vector2f reach = static_cast<float>(kReach + 1) * line.along_anchor;
  if (!can_be_sampled(pair_.anchor.intensity, centre - reach) ||
      !can_be_sampled(pair_.anchor.intensity, centre + reach)) {
    return false;
  }
  for (int k = 0; k < kSampled; ++k) {
    const Eigen::Vector2f at = centre + static_cast<float>(k - kReach - 1) * line.along_anchor;
    line.anchor[static_cast<std::size_t>(k)] =
        pair_.gain * sample_bilinear(pair_.anchor.intensity, at) + pair_.offset;
  }
  const auto s_of = [&](float inverse_depth) {
    Eigen::Vector3f P = line.R_ray + inverse_depth * pair_.t_cur_anchor;
    P.z() = std::max(P.z(), 0.1F);
    return (P.hnormalized() - line.q).dot(line.dq_ds) / line.dq_ds.squaredNorm();
  };
  constexpr float kMargin = 0.5F;  // px
  const float half = 0.5F * static_cast<float>(options_.max_search_px);
  const float near = s_of(target.nearest);
  const float far = s_of(target.farthest);
  line.s_min = std::max(std::min(near, far) - kMargin, -half);
  line.s_max = std::min(std::max(near, far) + kMargin, half);
  return true;
}

/// Intensities of the current image along the searched interval and what is compared beside it.
void EpipolarSearch::sample_line(const Line& line) {
  constexpr float kStraight = 8;  // px; a lens bends a line of this length by less than 0.05 px
  const GrayImage& image = pair_.current.intensity;
  const float first = line.s_min - static_cast<float>(kReach) * line.step;
  const float last = first + static_cast<float>(samples_.size() - 1) * line.step;
  const bool is_straight = pair_.current.camera.distortion.is_zero() || last - first <= kStraight;
  const LinePixels pixels(line.imaged, line.dq_ds, 0);
  const bool is_inside = is_straight && pixels.can_be_sampled(image, first, last);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const float at = first + static_cast<float>(i) * line.step;
    const Eigen::Vector2f pixel =
        is_straight ? pixels.at(at)
                    : image_ray(pair_.current.camera, line.q + at * line.dq_ds).pixel;
    samples_[i] = is_inside || can_be_sampled(image, pixel)
                      ? sample_bilinear(image, pixel)
                      : std::numeric_limits<float>::quiet_NaN();
  }
}

/// The place on the line, in steps of a sample, with the least sum of squared differences.
SearchOutcome EpipolarSearch::coarse_match(const Line& line, float& s) {
  constexpr float kNoSearch = 1.5F;  // px; the slope leads there from anywhere in it
  if (line.s_max - line.s_min <= kNoSearch) {
    s = std::clamp(0.0F, line.s_min, line.s_max);
    return SearchOutcome::found;
  }
  const int shifts = 1 + static_cast<int>(std::ceil((line.s_max - line.s_min) / line.step));
  samples_.resize(static_cast<std::size_t>(shifts + 2 * kReach));
  differences_.assign(static_cast<std::size_t>(shifts), kUnseen);
  sample_line(line);
  std::size_t best = 0;
  for (std::size_t i = 0; i < differences_.size(); ++i) {
    float sum = 0;
    for (std::size_t k = 0; k < kCompared; ++k) {
      const float difference = samples_[i + k] - line.anchor[k + 1];
      sum += difference * difference;
    }
    differences_[i] = sum < kUnseen ? sum : kUnseen;
    best = differences_[i] < differences_[best] ? i : best;
  }
  if (differences_[best] >= kUnseen) {
    return SearchOutcome::out_of_view;
  }
  constexpr float kLongLine = 6;  // px
  const float noise = static_cast<float>(options_.sigma_grey) * kGreyLevel;
  const float limit = static_cast<float>(options_.ambiguity) *
                      std::max(differences_[best], 2 * kCompared * noise * noise);
  for (std::size_t i = 0; line.s_max - line.s_min > kLongLine && i < differences_.size(); ++i) {
    const bool is_apart = i + 1 < best || i > best + 1;
    const bool is_least = (i == 0 || differences_[i] <= differences_[i - 1]) &&
                          (i + 1 == differences_.size() || differences_[i] <= differences_[i + 1]);
    if (is_apart && is_least && differences_[i] < limit) {
      return SearchOutcome::ambiguous;
    }
  }
  s = line.s_min + static_cast<float>(best) * line.step;
  return SearchOutcome::found;
}

/// Gauss-Newton on s with the mean of both images' slopes; false where it leaves the interval or
/// the images disagree there.
bool EpipolarSearch::refine(const Line& line, float& s, Fit& fit) const {
  constexpr int kMaxIterations = 4;
  constexpr float kMaxStep = 0.5F;
  constexpr float kConverged = 0.01F;
  const float start = s;
  const bool is_straight = pair_.current.camera.distortion.is_zero();
  const LinePixels pixels(
      is_straight
          ? ImagedRay{line.imaged.pixel + start * (line.imaged.J * line.dq_ds), line.imaged.J}
          : image_ray(pair_.current.camera, line.q + start * line.dq_ds),
      line.dq_ds, start);
  const float reach = static_cast<float>(kReach + 1) * line.step;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    if (!pixels.can_be_sampled(pair_.current.intensity, s - reach, s + reach)) {
      return false;
    }
    std::array<float, kSampled> current{};
    for (std::size_t k = 0; k < kSampled; ++k) {
      const float offset = (static_cast<float>(k) - kReach - 1) * line.step;
      current[k] = sample_bilinear(pair_.current.intensity, pixels.at(s + offset));
    }
    float right = 0;
    fit = {};
    for (std::size_t k = 1; k + 1 < kSampled; ++k) {
      const float slope =
          0.25F / line.step *
          ((current[k + 1] - current[k - 1]) + (line.anchor[k + 1] - line.anchor[k - 1]));
      const float residual = current[k] - line.anchor[k];
      fit.information += slope * slope;
      right += slope * residual;
      fit.squares += residual * residual;
    }
    if (!(fit.information > 0)) {
      return false;
    }
    const float step = std::clamp(-right / fit.information, -kMaxStep, kMaxStep);
    s += step;
    if (std::abs(step) < kConverged) {
      break;
    }
  }
  const float limit = static_cast<float>(options_.max_residual) * kGreyLevel;
  constexpr float kMisplaced2 = 0.1F;  // px^2; interpolation errs by as much on a strong edge
  return fit.squares <= kCompared * limit * limit + kMisplaced2 * fit.information &&
         std::abs(s - start) <= 1.5F * std::max(line.step, 1.0F);
}

/// px^2, across the edge: how much the pose's error moves the point there.
float EpipolarSearch::pose_variance(const Line& line, const Eigen::Vector3f& P,
                                    float inverse_depth) const {
  if (pair_.pose_is_exact) {
    return 0;
  }
  const Eigen::Matrix2f J = image_ray(pair_.current.camera, P.hnormalized()).J;
  const Eigen::Vector2f along = (J * line.dq_ds).normalized();
  const Eigen::Vector2f across_edge(line.cosine * along.x() - line.sine * along.y(),
                                    line.cosine * along.y() + line.sine * along.x());
  const Eigen::Vector2f by_ray = J.transpose() * across_edge / P.z();
  const Eigen::Vector3f by_point(by_ray.x(), by_ray.y(), -by_ray.dot(P.hnormalized()));
  Eigen::Matrix<float, 6, 1> by_pose;
  by_pose << inverse_depth * by_point, P.cross(by_point);
  return by_pose.dot(pair_.covariance * by_pose);
}

Observation EpipolarSearch::found(const Line& line, float inverse_depth, const Fit& fit) const {
  const Eigen::Vector3f P = line.R_ray + inverse_depth * pair_.t_cur_anchor;
  const Eigen::Vector3f& t = pair_.t_cur_anchor;
  const Eigen::Vector2f dq_dd = (t.head<2>() * P.z() - P.head<2>() * t.z()) / (P.z() * P.z());
  const float px_per_inverse_depth = dq_dd.dot(line.dq_ds) / line.dq_ds.squaredNorm();
  const auto sigma_line = static_cast<float>(options_.sigma_line_px);
  const auto sigma_match = static_cast<float>(options_.sigma_match_px);
  const auto sigma_grey = static_cast<float>(options_.sigma_grey) * kGreyLevel;
  const float across = sigma_line * sigma_line + pose_variance(line, P, inverse_depth);
  const float noise = 0.5F * (2 * sigma_grey * sigma_grey + fit.squares / (kCompared - 1));
  const float variance_px =
      across / (line.cosine * line.cosine) + noise / fit.information + sigma_match * sigma_match;
  const auto offset_px = static_cast<float>(options_.sigma_offset_px) * line.step / line.cosine;
  return {SearchOutcome::found, inverse_depth,
          variance_px / (px_per_inverse_depth * px_per_inverse_depth),
          offset_px / px_per_inverse_depth};
}

Observation EpipolarSearch::observe(const SearchTarget& target) {
  Line line;
  if (!make_line(target, line)) {
    return {SearchOutcome::unobservable};
  }
  if (!sample_anchor(target, line)) {
    return {SearchOutcome::out_of_view};
  }
  float s = 0;
  const SearchOutcome outcome = coarse_match(line, s);
  if (outcome != SearchOutcome::found) {
    return {outcome};
  }
  Fit fit;
  if (!refine(line, s, fit)) {
    return {SearchOutcome::no_match};
  }
  const Eigen::Vector2f q = line.q + s * line.dq_ds;
  const Eigen::Vector3f& t = pair_.t_cur_anchor;
  const int axis = std::abs(line.dq_ds.x()) > std::abs(line.dq_ds.y()) ? 0 : 1;
  const float inverse_depth =
      (line.R_ray[axis] - q[axis] * line.R_ray.z()) / (q[axis] * t.z() - t[axis]);
  if (!(inverse_depth > 0)) {
    return {SearchOutcome::no_match};
  }
  return found(line, inverse_depth, fit);
}

}  // namespace vo
