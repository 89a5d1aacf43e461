#include "synth/truth/pixel_truth.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "synth/rendering/surface_ids.h"

namespace synth {
namespace {

/// Returns an image of `value` of each point, 0 where nothing was hit.
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

IdImage id_image(const PointImage& points, const std::vector<std::uint16_t>& id_of_mesh) {
  return image_of<std::uint16_t>(points, [&](const TrianglePoint& point) {
    return id_of_mesh[static_cast<std::size_t>(point.mesh)];
  });
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

IdImage instance_truth(const PointImage& points, const WorldGeometry& world) {
  return id_image(points, surface_ids(world).instance);
}

IdImage material_truth(const PointImage& points, const WorldGeometry& world) {
  return id_image(points, surface_ids(world).material);
}

IdImage class_truth(const PointImage& points, const WorldGeometry& world,
                    const std::vector<std::uint16_t>& instance_classes) {
  return image_of<std::uint16_t>(points, [&](const TrianglePoint& point) {
    const FlatMesh& mesh = world.meshes[static_cast<std::size_t>(point.mesh)];
    return instance_classes[static_cast<std::size_t>(mesh.instance)];
  });
}

}  // namespace synth
