#include "tools/train_edges/edge_patch.h"

#include <cstddef>
#include <cstdlib>

namespace tools {
namespace {

std::size_t bit(const cv::Point& pixel) {
  const int index = kPatchSide * pixel.x + pixel.y;
  return static_cast<std::size_t>(index);
}

cv::Point random_pixel(vo::Random& random) {
  const int u = random.below(kPatchSide);
  return {u, random.below(kPatchSide)};
}

}  // namespace

EdgePatch edge_patch(const synth::EdgeLabels& labels, const cv::Point& corner) {
  EdgePatch patch;
  for (int u = 0; u < kPatchSide; ++u) {
    for (int v = 0; v < kPatchSide; ++v) {
      patch[bit({u, v})] = labels(corner.y + v, corner.x + u) != 0;
    }
  }
  return patch;
}

EdgePatch line_between(const cv::Point& from, const cv::Point& to) {
  const cv::Point length(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const cv::Point step(to.x > from.x ? 1 : -1, to.y > from.y ? 1 : -1);
  EdgePatch line;
  cv::Point at = from;
  int along_x = 0;
  int along_y = 0;
  while (along_x + along_y + 1 < length.x + length.y) {
    // Steps one pixel along the axis whose next grid line is crossed first.
    if ((1 + 2 * along_x) * length.y < (1 + 2 * along_y) * length.x) {
      at.x += step.x;
      ++along_x;
    } else {
      at.y += step.y;
      ++along_y;
    }
    line.set(bit(at));
  }
  return line;
}

std::vector<EdgePatch> random_lines(int count, vo::Random& random) {
  std::vector<EdgePatch> lines;
  while (lines.size() < static_cast<std::size_t>(count)) {
    const cv::Point from = random_pixel(random);
    const EdgePatch line = line_between(from, random_pixel(random));
    if (line.any()) {
      lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace tools
