#include "tools/bench/opencv_peer.h"

namespace tools {

std::optional<Peer> opencv_peer(OpencvOdometry /*kind*/) {
  return std::nullopt;
}

}  // namespace tools
