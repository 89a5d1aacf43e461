#pragma once

#include <filesystem>
#include <functional>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>

#include "tests/support/plane_frames.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/sequence_source.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"

namespace support {

/// Writers of the layouts that are read, each from its description and not from our readers.

/// The textured plane at 30 Hz from the sway, 160x120 px, in three colours that differ and whose
/// luma has the contrast of the plane's grey, more or less.
inline vo::SequenceSource rendered_sequence(int frames) {
  vo::SequenceSource source;
  source.camera = {vo::PinholeCamera::from_horizontal_fov(160, 120, 60), 1000};
  for (int i = 0; i < frames; ++i) {
    source.timestamps.push_back(i / 30.0);
    source.truth.push_back({i / 30.0, sway(i)});
  }
  source.read = [camera = source.camera.pinhole](std::size_t index) {
    vo::RgbdFrame frame = sway_frame(camera, static_cast<int>(index));
    vo::ColorImage color(frame.image.size());
    for (int i = 0; i < static_cast<int>(frame.image.total()); ++i) {
      const uchar grey = frame.image.at<uchar>(i / color.cols, i % color.cols);
      color(i / color.cols, i % color.cols) = {static_cast<uchar>(grey / 2), grey,
                                               static_cast<uchar>(255 - grey / 4)};
    }
    frame.image = color;
    return frame;
  };
  return source;
}

/// Encodes an image, and the ending of files in that format.
struct ImageFormat {
  std::string ending;
  std::function<std::string(const cv::Mat& image)> encode;
};

inline ImageFormat png_images() {
  return {".png", vo::encode_png};
}

inline std::string padded(std::size_t number, int digits) {
  std::ostringstream text;
  text << std::setw(digits) << std::setfill('0') << number;
  return text.str();
}

/// The four rows of a matrix, each number in the digits that read back as the same.
inline std::string matrix_rows(const Eigen::Matrix4d& matrix) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      text << matrix(row, column) << (column == 3 ? "\n" : " ");
    }
  }
  return text.str();
}

inline Eigen::Matrix4d matrix_of(const vo::SE3& T) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = T.rotation_matrix();
  matrix.topRightCorner<3, 1>() = T.translation();
  return matrix;
}

inline std::string depth_in_millimetres(const vo::DepthImage& depth) {
  return vo::encode_png(vo::to_depth_units(depth, 1000));
}

inline void write_seven_scenes(const std::filesystem::path& folder,
                               const vo::SequenceSource& source,
                               const ImageFormat& images = png_images()) {
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const vo::RgbdFrame frame = source.read(i);
    const std::string name = "frame-" + padded(i, 6);
    vo::write_files(folder,
                    {{name + ".color" + images.ending, images.encode(frame.image)},
                     {name + ".depth.png", depth_in_millimetres(frame.depth)},
                     {name + ".pose.txt", matrix_rows(matrix_of(source.truth[i].T_world_camera))}});
  }
  vo::write_files(folder, {{"camera.toml", vo::format_camera(source.camera)}});
}

inline std::string camera_rows(const vo::PinholeCamera& camera) {
  Eigen::Matrix4d K = Eigen::Matrix4d::Identity();
  K(0, 0) = camera.fx;
  K(1, 1) = camera.fy;
  K(0, 2) = camera.cx;
  K(1, 2) = camera.cy;
  return matrix_rows(K);
}

inline void write_scannet(const std::filesystem::path& folder, const vo::SequenceSource& source,
                          const ImageFormat& images = png_images()) {
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const vo::RgbdFrame frame = source.read(i);
    const std::string name = std::to_string(i);
    vo::write_files(folder, {{"color/" + name + images.ending, images.encode(frame.image)},
                             {"depth/" + name + ".png", depth_in_millimetres(frame.depth)},
                             {"pose/" + name + ".txt",
                              matrix_rows(matrix_of(source.truth[i].T_world_camera))}});
  }
  const std::string identity = matrix_rows(Eigen::Matrix4d::Identity());
  vo::write_files(folder, {{"intrinsic/intrinsic_color.txt", camera_rows(source.camera.pinhole)},
                           {"intrinsic/intrinsic_depth.txt", camera_rows(source.camera.pinhole)},
                           {"intrinsic/extrinsic_color.txt", identity},
                           {"intrinsic/extrinsic_depth.txt", identity}});
}

inline std::string open3d_intrinsics(const vo::PinholeCamera& camera) {
  std::ostringstream text;
  text << std::setprecision(17) << "{\n    \"height\" : " << camera.height
       << ",\n    \"intrinsic_matrix\" : \n    [\n        " << camera.fx << ",\n 0,\n 0,\n 0,\n "
       << camera.fy << ",\n 0,\n " << camera.cx << ",\n " << camera.cy
       << ",\n 1\n    ],\n    \"width\" : " << camera.width << "\n}";
  return text.str();
}

inline void write_open3d(const std::filesystem::path& folder, const vo::SequenceSource& source,
                         const ImageFormat& images = png_images()) {
  std::string log;
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const vo::RgbdFrame frame = source.read(i);
    vo::write_files(folder,
                    {{"color/" + padded(i, 6) + images.ending, images.encode(frame.image)},
                     {"depth/" + padded(i, 6) + ".png", depth_in_millimetres(frame.depth)}});
    const std::string number = std::to_string(i);
    log += number + " " + number + " " + std::to_string(i + 1) + "\n" +
           matrix_rows(matrix_of(source.truth[i].T_world_camera));
  }
  vo::write_files(folder, {{"trajectory.log", log},
                           {"camera_intrinsic.json", open3d_intrinsics(source.camera.pinhole)}});
}

/// TartanAir's camera and world have x forward, y right and z down: a vector (x, y, z) of ours is
/// (z, x, y) there, and of a rotation, the axis is such a vector.
inline void write_tartanair(const std::filesystem::path& folder, const vo::SequenceSource& source,
                            const ImageFormat& images = png_images()) {
  std::ostringstream poses;
  poses << std::setprecision(17);
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    const vo::RgbdFrame frame = source.read(i);
    vo::write_files(
        folder,
        {{"image_left/" + padded(i, 6) + "_left" + images.ending, images.encode(frame.image)},
         {"depth_left/" + padded(i, 6) + "_left_depth.npy", vo::encode_npy(frame.depth)}});
    const Eigen::Vector3d& t = source.truth[i].T_world_camera.translation();
    const Eigen::Quaterniond& q = source.truth[i].T_world_camera.rotation();
    poses << t.z() << " " << t.x() << " " << t.y() << " " << q.z() << " " << q.x() << " " << q.y()
          << " " << q.w() << "\n";
  }
  vo::write_files(
      folder, {{"pose_left.txt", poses.str()}, {"camera.toml", vo::format_camera(source.camera)}});
}

}  // namespace support
