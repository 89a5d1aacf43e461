#pragma once

#include <array>
#include <utility>

namespace vo {

/// The state of the odometry says what is known of the camera after a frame.
enum class MonoState {
  initialising,  ///< nothing: an unknown start waits for parallax
  orienting,  ///< the rotation: depths are guessed until a start is found, translations mean little
  tracking,   ///< the pose, in a map
  scale_uncertain,  ///< the pose, in a map whose scale may have drifted by more than a quarter
  lost,             ///< nothing: the map is out of view
  reinitialising,   ///< nothing: a new map is looked for beside the lost one
};

constexpr auto enum_names(MonoState) {
  return std::array{std::pair{MonoState::initialising, "initialising"},
                    std::pair{MonoState::orienting, "orienting"},
                    std::pair{MonoState::tracking, "tracking"},
                    std::pair{MonoState::scale_uncertain, "scale_uncertain"},
                    std::pair{MonoState::lost, "lost"},
                    std::pair{MonoState::reinitialising, "reinitialising"}};
}

/// Returns whether the pose is known in a map in this state.
constexpr bool is_in_map(MonoState state) {
  return state == MonoState::tracking || state == MonoState::scale_uncertain;
}

}  // namespace vo
