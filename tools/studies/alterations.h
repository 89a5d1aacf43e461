#pragma once

#include <span>
#include <string_view>

#include "tools/studies/clip.h"

namespace tools {

/// A way to alter a recorded clip: another circumstance, whose truth is as well known, or a fault
/// of the camera, its driver or the world. Images are replaced, never written.
struct Alteration {
  std::string_view name;
  std::string_view description;
  void (*apply)(Clip& clip);
};

/// Returns all alterations, "none" first.
std::span<const Alteration> alterations();

/// Returns the clip altered. Throws vo::Error unless there is an alteration of this name.
Clip altered(const Clip& clip, std::string_view name);

}  // namespace tools
