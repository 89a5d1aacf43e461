#include "vo/tracking/local_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vo/core/error.h"
#include "vo/tracking/image_motion.h"

namespace vo {
namespace {

/// Rescales the points' intensities and gradients, neglecting the vignette's own gradient.
void take_out(const Vignette& vignette, const PinholeCamera& camera, const Vignette& before,
              EdgePointLevel& points) {
  const VignetteTerms terms(camera);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d at_pixel = terms.at(points.pixel[i].x, points.pixel[i].y);
    const auto gain = static_cast<float>(vignette.gain(at_pixel) / before.gain(at_pixel));
    for (std::vector<float>* values :
         {&points.intensity, &points.dI_dx, &points.dI_dy, &points.dI_dz}) {
      (*values)[i] *= gain;
    }
  }
}

/// Returns the keyframe as it would be if this vignette had been removed from its image.
Keyframe without_vignette(Keyframe keyframe, const Vignette& vignette) {
  EdgePoints points = *keyframe.points;
  for (std::size_t l = 0; l < points.levels.size(); ++l) {
    take_out(vignette, keyframe.pyramid.levels[l].camera, keyframe.pyramid.vignette,
             points.levels[l]);
  }
  keyframe.pyramid = without_vignette(std::move(keyframe.pyramid), vignette);
  keyframe.points = std::make_shared<const EdgePoints>(std::move(points));
  return keyframe;
}

/// Returns the depths measured at a keyframe's finest points but for those in the tiles.
std::vector<float> measured_outside(const TileMask& tiles, const Keyframe& keyframe) {
  const ViewTiles grid(keyframe.pyramid.levels.front().camera);
  std::vector<float> left;
  for (std::size_t i = 0; i < keyframe.measured_depth.size(); ++i) {
    if (!tiles[grid.of(keyframe.points->levels.front().pixel[i])]) {
      left.push_back(keyframe.measured_depth[i]);
    }
  }
  return left;
}

}  // namespace

void MapOptions::validate() const {
  require(references >= 1 && references <= static_cast<int>(kMaxReferences),
          "map.references: expected 1 to ", kMaxReferences, ", got ", references);
  require(max_keyframes >= references, "map.max_keyframes: expected at least map.references, got ",
          max_keyframes);
  require(min_overlap >= 0 && min_overlap <= 1, "map.min_overlap: expected 0 to 1, got ",
          min_overlap);
}

void LocalMap::add(Keyframe keyframe) {
  keyframes_.push_back(std::make_shared<const Keyframe>(std::move(keyframe)));
  if (keyframes_.size() > static_cast<std::size_t>(options_.max_keyframes)) {
    keyframes_.pop_front();
  }
}

std::size_t LocalMap::memory_bytes() const {
  std::size_t bytes = 0;
  for (const std::shared_ptr<const Keyframe>& keyframe : keyframes_) {
    bytes += vo::memory_bytes(keyframe->pyramid) + vo::memory_bytes(*keyframe->points);
    bytes += keyframe->surface != nullptr ? keyframe->surface->memory_bytes() : 0;
    bytes += keyframe->measured_depth.size() * sizeof(float);
  }
  return bytes;
}

void LocalMap::take_out(const Vignette& vignette) {
  for (std::shared_ptr<const Keyframe>& keyframe : keyframes_) {
    if (is_noticeable(keyframe->pyramid.vignette, vignette)) {
      keyframe = std::make_shared<const Keyframe>(without_vignette(*keyframe, vignette));
    }
  }
}

void LocalMap::forget_bent(const Readout& readout) {
  constexpr double kMaxBend = 0.5;  // px, mean of all points
  constexpr double kSame = 1e-3;    // s
  const auto is_bent = [&](const std::shared_ptr<const Keyframe>& keyframe) {
    const Readout& then = keyframe->readout;
    const double change = then.axis == readout.axis ? std::abs(readout.seconds - then.seconds)
                                                    : std::hypot(readout.seconds, then.seconds);
    if (keyframe == last() || !keyframe->velocity || change < kSame) {
      return false;
    }
    const SE3 motion = SE3::exp(change * keyframe->velocity->twist);
    return image_motion(*keyframe->points, keyframe->pyramid, motion).flow_px > kMaxBend;
  };
  std::erase_if(keyframes_, is_bent);
}

void LocalMap::set_last_velocity(const FrameVelocity& velocity) {
  Keyframe keyframe = *keyframes_.back();
  keyframe.velocity = velocity;
  keyframes_.back() = std::make_shared<const Keyframe>(std::move(keyframe));
}

void LocalMap::set_last_points(std::shared_ptr<const EdgePoints> points) {
  Keyframe keyframe = *keyframes_.back();
  keyframe.points = std::move(points);
  if (!keyframe.measured_depth.empty()) {
    keyframe.measured_depth = keyframe.points->levels.front().z_ref;
  }
  keyframes_.back() = std::make_shared<const Keyframe>(std::move(keyframe));
}

void LocalMap::leave_out(const Keyframe& keyframe, const TileMask& tiles) {
  const auto found = std::find_if(keyframes_.begin(), keyframes_.end(),
                                  [&](const auto& each) { return each.get() == &keyframe; });
  if (found == keyframes_.end()) {
    return;
  }
  Keyframe left = keyframe;
  left.moved |= tiles;
  left.measured_depth = measured_outside(tiles, keyframe);
  auto points = std::make_shared<EdgePoints>(*keyframe.points);
  vo::leave_out(tiles, keyframe.pyramid, *points);
  left.points = std::move(points);
  if (keyframe.surface != nullptr) {
    auto surface = std::make_shared<SurfacePoints>(*keyframe.surface);
    vo::leave_out(tiles, keyframe.pyramid, *surface);
    left.surface = std::move(surface);
  }
  *found = std::make_shared<const Keyframe>(std::move(left));
}

void LocalMap::adjust(std::size_t keyframe, const SE3& T_world_keyframe, EdgePointLevel finest) {
  Keyframe adjusted = *keyframes_[keyframe];
  adjusted.T_world_keyframe = T_world_keyframe;
  EdgePoints points = *adjusted.points;
  points.levels.front() = std::move(finest);
  adjusted.points = std::make_shared<const EdgePoints>(std::move(points));
  keyframes_[keyframe] = std::make_shared<const Keyframe>(std::move(adjusted));
}

/// Returns at most `count` keyframes that overlap enough, least displacement first.
LocalMap::Ranking LocalMap::seen_from(const SE3& T_world_camera, std::size_t count) const {
  Ranking ranked;
  for (std::size_t k = 0; k < keyframes_.size(); ++k) {
    const Keyframe& keyframe = *keyframes_[k];
    const ImageMotion motion = image_motion(*keyframe.points, keyframe.pyramid,
                                            T_world_camera.inverse() * keyframe.T_world_keyframe);
    if (motion.overlap >= options_.min_overlap) {
      auto* place = std::upper_bound(
          ranked.begin(), ranked.end(), motion.flow_px,
          [](double flow_px, const RankedKeyframe& other) { return flow_px < other.flow_px; });
      const auto rank = place - ranked.begin();
      ranked.push_back({motion.flow_px, k});
      std::rotate(ranked.begin() + rank, ranked.end() - 1, ranked.end());
    }
    if (ranked.size() > count) {
      ranked.pop_back();
    }
  }
  return ranked;
}

LocalMap::References LocalMap::references_for(const SE3& T_world_camera) const {
  References references;
  if (options_.references > 1) {
    const auto count = static_cast<std::size_t>(options_.references);
    for (const RankedKeyframe& ranked : seen_from(T_world_camera, count)) {
      references.push_back(keyframes_[ranked.index]);
    }
  }
  if (references.empty()) {
    references.push_back(keyframes_.back());
  }
  return references;
}

std::vector<std::size_t> LocalMap::around_last(std::size_t count) const {
  const std::size_t last = keyframes_.size() - 1;
  std::vector<std::size_t> result;
  for (const RankedKeyframe& ranked : seen_from(keyframes_.back()->T_world_keyframe, count)) {
    result.push_back(ranked.index);
  }
  const auto found = std::find(result.begin(), result.end(), last);
  if (found == result.end()) {
    result.insert(result.begin(), last);
    result.resize(std::min(result.size(), count));
  } else {
    std::rotate(result.begin(), found, found + 1);
  }
  return result;
}

}  // namespace vo
