#include "synth/pixel_truth.h"

#include <cstddef>
#include <limits>

#include "vo/core/error.h"

namespace synth {
namespace {

/// `value` of each point, 0 where nothing was hit.
template <typename Pixel, typename Value>
cv::Mat_<Pixel> image_of(const PointImage& points, Value value) {
  cv::Mat_<Pixel> image(points.size);
  auto pixel = image.begin();
  for (const TrianglePoint& point : points.points) {
    *pixel = point.exists() ? value(point) : Pixel();
    ++pixel;
  }
  return image;
}

void require_16_bits(std::size_t count, const char* what) {
  constexpr std::size_t kMax = std::numeric_limits<std::uint16_t>::max();
  vo::require(count <= kMax, "ground truth: the scene has ", count, " ", what,
              ", expected at most ", kMax, " for 16-bit ids");
}

}  // namespace

vo::DepthImage depth_truth(const PointImage& points) {
  return image_of<float>(
      points, [](const TrianglePoint& point) { return static_cast<float>(point.depth); });
}

cv::Mat_<cv::Vec3f> normal_truth(const PointImage& points, const PointTracer& tracer,
                                 const Eigen::Vector3d& eye) {
  return image_of<cv::Vec3f>(points, [&](const TrianglePoint& point) {
    const Eigen::Vector3f normal = tracer.face_normal(point, eye).cast<float>();
    return cv::Vec3f(normal.x(), normal.y(), normal.z());
  });
}

IdImage instance_truth(const PointImage& points, const FlatScene& flat) {
  require_16_bits(flat.scene->instances.size(), "instances");
  return image_of<std::uint16_t>(points, [&](const TrianglePoint& point) {
    return static_cast<std::uint16_t>(flat.meshes[point.mesh].instance + 1);
  });
}

IdImage material_truth(const PointImage& points, const FlatScene& flat) {
  const std::size_t count = flat.scene->materials.size();
  require_16_bits(count + 1, "materials and the default");
  return image_of<std::uint16_t>(points, [&](const TrianglePoint& point) {
    const int material = flat.meshes[point.mesh].mesh->material;
    return static_cast<std::uint16_t>(1 + (material == kNone ? count : material));
  });
}

}  // namespace synth
