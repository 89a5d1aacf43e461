#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

using Eigen::Vector3d;

/// Returns a box each side of which shows the whole image.
Shape dice(const Vector3d& size) {
  Shape shape = box(size);
  for (std::size_t i = 0; i < shape.texcoords.size(); ++i) {
    Vector3d along = size;
    if (shape.normals[i].x() != 0) {
      along.x() = size.z();
    } else if (shape.normals[i].y() != 0) {
      along.y() = size.z();
    }
    shape.texcoords[i] =
        shape.texcoords[i].cwiseQuotient(along.head<2>()) + Eigen::Vector2d::Constant(0.5);
  }
  return shape;
}

}  // namespace

/// The coordinates are multiples of 1/8 m, exact as float and in the file.
Model make_plane_and_box() {
  ModelBuilder scene("plane_and_box");
  const int root = scene.add_group(kNone, "plane_and_box", Eigen::Isometry3d::Identity());
  Mesh plane = {"plane", {}};
  add(plane, Finish::mosaic, panel(6, 3));
  scene.place(root, "plane", scene.add_mesh(plane), Eigen::Isometry3d::Identity());
  Mesh box_mesh = {"box", {}};
  add(box_mesh, Finish::mosaic_box, dice({1, 0.75, 0.5}));
  scene.place(root, "box", scene.add_mesh(box_mesh), at(0.25, 0, 0.75));
  return scene.model();
}

}  // namespace scenes
