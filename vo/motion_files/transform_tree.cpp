#include "vo/motion_files/transform_tree.h"

#include <algorithm>
#include <optional>
#include <set>

#include "vo/core/error.h"

namespace vo {
namespace {

bool is_same(const SE3& a, const SE3& b) {
  return a.translation() == b.translation() && a.rotation().coeffs() == b.rotation().coeffs();
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text.empty() ? "none" : text;
}

}  // namespace

void TransformTree::add(const std::string& parent, const std::string& child,
                        const StampedPose& T_parent_child) {
  const auto found = links_.try_emplace(child, Link{parent, {}}).first;
  if (found->second.parent == parent && !found->second.is_fixed) {
    found->second.T_parent_child.push_back(T_parent_child);
  }
}

void TransformTree::add_fixed(const std::string& parent, const std::string& child,
                              const SE3& T_parent_child) {
  links_.try_emplace(child, Link{parent, {{0, T_parent_child}}, true});
}

void TransformTree::finish() {
  for (auto& [child, link] : links_) {
    Trajectory& poses = link.T_parent_child;
    std::stable_sort(poses.begin(), poses.end(),
                     [](const auto& a, const auto& b) { return a.timestamp < b.timestamp; });
    poses.erase(
        std::unique(poses.begin(), poses.end(),
                    [](const auto& a, const auto& b) { return a.timestamp == b.timestamp; }),
        poses.end());
    link.is_fixed = std::all_of(poses.begin(), poses.end(), [&](const StampedPose& pose) {
      return is_same(pose.T_world_camera, poses.front().T_world_camera);
    });
  }
}

std::vector<std::string> TransformTree::above(const std::string& frame) const {
  std::vector<std::string> names;
  std::set<std::string> seen = {frame};
  for (auto link = links_.find(frame); link != links_.end();
       link = links_.find(link->second.parent)) {
    if (!seen.insert(link->second.parent).second) {
      break;  // a circle, which no tree has
    }
    names.push_back(link->second.parent);
  }
  return names;
}

std::vector<std::string> TransformTree::moving() const {
  std::vector<std::string> names;
  for (const auto& [child, link] : links_) {
    if (!link.is_fixed) {
      names.push_back(child);
    }
  }
  return names;
}

std::vector<std::string> TransformTree::frames() const {
  std::set<std::string> names;
  for (const auto& [child, link] : links_) {
    names.insert(child);
    names.insert(link.parent);
  }
  return {names.begin(), names.end()};
}

Trajectory TransformTree::poses(const std::string& parent, const std::string& child) const {
  const std::vector<std::string> parents = above(child);
  const auto end = std::find(parents.begin(), parents.end(), parent);
  require(end != parents.end(), "/tf: ", parent, " is not above ", child,
          "; its frames: ", listed(frames()), "; above ", child, ": ", listed(parents));
  Trajectory result = {{0, {}}};
  bool is_moving = false;
  std::string frame = child;
  for (auto above = parents.begin(); above <= end; frame = *above, ++above) {
    const Link& link = links_.at(frame);
    if (!link.is_fixed && !is_moving) {
      const SE3 T_frame_child = result.front().T_world_camera;
      result = link.T_parent_child;
      for (StampedPose& pose : result) {
        pose.T_world_camera = pose.T_world_camera * T_frame_child;
      }
      is_moving = true;
      continue;
    }
    Trajectory next;
    for (const StampedPose& pose : result) {
      const std::optional<SE3> T_parent_frame =
          link.is_fixed ? std::optional(link.T_parent_child.front().T_world_camera)
                        : pose_at(link.T_parent_child, pose.timestamp);
      if (T_parent_frame) {
        next.push_back({pose.timestamp, *T_parent_frame * pose.T_world_camera});
      }
    }
    result = std::move(next);
  }
  return result;
}

}  // namespace vo
