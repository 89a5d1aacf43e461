#include "vo/image/view_cells.h"

#include <vector>

namespace vo {

void leave_out(const ViewCells::Set& cells, const FramePyramid& frame, EdgePoints& points) {
  if (cells.none()) {
    return;
  }
  std::vector<std::size_t> kept;
  for (std::size_t l = 0; l < points.levels.size(); ++l) {
    const ViewCells grid(frame.levels[l].camera);
    EdgePointLevel& level = points.levels[l];
    kept.clear();
    for (std::size_t i = 0; i < level.size(); ++i) {
      const cv::Point& pixel = level.pixel[i];
      if (!cells[grid.of(static_cast<float>(pixel.x), static_cast<float>(pixel.y))]) {
        kept.push_back(i);
      }
    }
    level.keep(kept);
  }
}

}  // namespace vo
