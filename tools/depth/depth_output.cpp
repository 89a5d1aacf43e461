#include "tools/depth/depth_output.h"

#include <array>
#include <cstdio>

#include "tools/depth/depth_course.h"
#include "tools/depth/depth_pictures.h"
#include "tools/depth/depth_table.h"
#include "tools/depth/mono_run.h"
#include "tools/plot/table.h"
#include "vo/image_files/png.h"

namespace tools {
namespace {

std::string frame_name(std::size_t frame) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%06zu.png", frame);
  return name.data();
}

}  // namespace

double divisor(const vo::DepthMap& map, const vo::DepthImage& true_depth, MapScale scale) {
  return scale == MapScale::metric ? 1 : map_errors(map, {true_depth, {}}, {}).scale;
}

DepthOutput::DepthOutput(const std::filesystem::path& folder, int every,
                         const vo::OutputPolicy& policy, const vo::WaitObserver& waiting)
    : every_(every), folder_(folder, policy, waiting) {}

MapObserver DepthOutput::observer(MapScale scale) {
  return [this, scale](std::size_t frame, const vo::DepthMap& map, const vo::DepthImage& truth,
                       const vo::SE3& T_world_host) {
    if (every_ == 0 || frame % static_cast<std::size_t>(every_) != 0) {
      return;
    }
    folder_.write({{frame_name(frame),
                    vo::encode_png(draw_depth_map(map, truth, divisor(map, truth, scale)))}});
    cloud_ = cloud_of(map, T_world_host);
  };
}

void DepthOutput::commit(const std::vector<MappedFrame>& frames) {
  folder_.write({{"depth.csv", as_csv(depth_table(frames))}});
  folder_.write({{"course.svg", draw_course(frames)}});
  if (cloud_) {
    folder_.write({{"cloud.ply", encode(*cloud_, CloudFormat::ply)}});
    folder_.write({{"cloud.pcd", encode(*cloud_, CloudFormat::pcd)}});
  }
  folder_.commit();
}

}  // namespace tools
