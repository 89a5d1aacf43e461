#pragma once

#include <string>

#include "vo/evaluation/evaluate.h"

namespace tools {

/// Returns how an estimate was brought onto the truth, for titles: `not aligned` or, for example,
/// `aligned by SE(3)`.
std::string alignment_text(vo::TrajectoryAlignment alignment);

/// Returns an axis' title such as `ATE, mm, aligned by SE(3)`.
std::string ate_title(const std::string& unit, vo::TrajectoryAlignment alignment);

/// Returns an axis' title such as `RPE over 1 s, mm`; `interval` is in s.
std::string rpe_title(const std::string& unit, double interval);

}  // namespace tools
