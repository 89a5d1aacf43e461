#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "synth/scene/scene.h"
#include "synth/sequence/generate.h"

namespace synth {

/// The share of pixels with depth below which a sequence is warned about.
inline constexpr double kLeastDepthCoverage = 0.2;

/// Returns the share of the pixels of the 16-bit depth images in `folder` that hold a depth, 0 to
/// 1; nothing if none of these images can be read. Those of `frames` that are not there, or cannot
/// be read, do not count.
std::optional<double> depth_coverage(const SequenceRecipe& recipe,
                                     const std::vector<std::size_t>& frames,
                                     const std::filesystem::path& folder);

/// Returns a sentence about a sequence with little depth, empty where `coverage` is enough. Where
/// the scene is so large that its unit seems to be the millimetre, it names the option that mends
/// it.
std::string warn_of_coverage(const Scene& scene, const SequenceRecipe& recipe, double coverage);

}  // namespace synth
