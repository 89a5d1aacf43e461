#pragma once

#include <cstdint>

namespace vo {

inline constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

}  // namespace vo
