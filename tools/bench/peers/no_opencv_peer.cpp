#include "tools/bench/opencv_peer.h"

namespace tools {

std::optional<Contestant> opencv_contestant(OpencvOdometry /*kind*/) {
  return std::nullopt;
}

}  // namespace tools
