#include "vo/exports/colmap.h"

#include <array>
#include <cstdio>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/sequence.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/timestamp.h"

namespace vo {
namespace {

constexpr int kFewestViews = 2;

/// Returns the name and the coefficients of a lens's model in COLMAP.
std::string format_colmap_lens(const PinholeCamera& camera) {
  const Distortion& lens = camera.distortion;
  std::string model = "PINHOLE";
  std::vector<double> values = {camera.fx, camera.fy, camera.cx + 0.5, camera.cy + 0.5};
  const auto add = [&](const char* name, std::initializer_list<double> coefficients) {
    model = name;
    values.insert(values.end(), coefficients);
  };
  if (lens.model == DistortionModel::kannala_brandt) {
    add("OPENCV_FISHEYE", {lens.k1, lens.k2, lens.k3, lens.k4});
  } else if (lens.k3 != 0 || lens.is_rational()) {
    add("FULL_OPENCV", {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, lens.k4, lens.k5, lens.k6});
  } else if (!lens.is_zero()) {
    add("OPENCV", {lens.k1, lens.k2, lens.p1, lens.p2});
  }
  std::string text = concat(model, " ", camera.width, " ", camera.height);
  for (const double value : values) {
    text += " " + format_real(value);
  }
  return text;
}

std::string format_colmap_pose(const SE3& T_camera_world) {
  const Eigen::Quaterniond& q = T_camera_world.rotation();
  const Eigen::Vector3d& t = T_camera_world.translation();
  std::string text;
  for (const double value : {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()}) {
    text += " " + format_real(value);
  }
  return text;
}

std::string format_colmap_pixel(const Eigen::Vector2d& pixel) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.3f %.3f", pixel.x() + 0.5, pixel.y() + 0.5);
  return text.data();
}

/// Returns, from 1, the number of each point that is written; 0 of one that too few frames see.
std::vector<std::size_t> numbers_of_points(const std::vector<SparsePoint>& points) {
  std::vector<std::size_t> numbers;
  std::size_t count = 0;
  for (const SparsePoint& point : points) {
    numbers.push_back(point.views >= kFewestViews ? ++count : 0);
  }
  return numbers;
}

std::string format_colmap_point(std::size_t number, const SparsePoint& point) {
  const cv::Vec3b& bgr = point.colour;
  const Eigen::Vector3d& p = point.p_world;
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%zu %.9g %.9g %.9g %d %d %d 0", number, p.x(), p.y(),
                p.z(), bgr[2], bgr[1], bgr[0]);
  return text.data();
}

}  // namespace

ColmapModel::ColmapModel(const SequenceSource& source)
    : source_(source), points_(source.camera.pinhole) {
  const std::vector<std::string> stamps = format_timestamps(source.timestamps);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    names_.push_back(frame_number(i) + "_" + stamps[i] + ".png");
  }
}

std::vector<NamedBytes> ColmapModel::encode_frame(std::size_t index, const RgbdFrame& frame) {
  points_.add(frame, *pose_at(source_.truth, frame.timestamp));
  return {{"images/" + names_.at(index), encode_png(frame.image)}};
}

std::vector<NamedBytes> ColmapModel::encode_lists() const {
  const std::vector<std::size_t> numbers = numbers_of_points(points_.points());
  std::vector<std::string> tracks(numbers.size());
  std::string images = "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME\n# X Y POINT3D_ID ...\n";
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const SE3 T_camera_world = pose_at(source_.truth, source_.timestamps[i])->inverse();
    images += concat(i + 1, format_colmap_pose(T_camera_world), " 1 ", names_[i], "\n");
    std::size_t seen = 0;
    for (const auto& [point, pixel] : points_.views().at(i)) {
      if (numbers[point] > 0) {
        images += concat(seen == 0 ? "" : " ", format_colmap_pixel(pixel), " ", numbers[point]);
        tracks[point] += concat(" ", i + 1, " ", seen++);
      }
    }
    images += "\n";
  }
  std::string points = "# POINT3D_ID X Y Z R G B ERROR (IMAGE_ID POINT2D_IDX) ...\n";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] > 0) {
      points += format_colmap_point(numbers[i], points_.points()[i]) + tracks[i] + "\n";
    }
  }
  return {{"sparse/0/cameras.txt", "# CAMERA_ID MODEL WIDTH HEIGHT PARAMS ...\n1 " +
                                       format_colmap_lens(source_.camera.pinhole) + "\n"},
          {"sparse/0/images.txt", images},
          {"sparse/0/points3D.txt", points}};
}

}  // namespace vo
