#include "synth/gltf/image_based_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "synth/gltf_document/check_image_based_lights.h"
#include "synth/gltf_model/image.h"
#include "synth/scene/srgb.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

constexpr int kMostFacePixels = 2048;  // of a side
constexpr int kMostRows = 1024;        // of the environment's image
constexpr int kSamples = 8;            // of a pixel of it, along each axis

/// A cube map as it is decoded: linear light is sRGB over alpha.
struct CubeMap {
  std::array<cv::Mat_<cv::Vec4b>, 6> faces;  ///< squares of one size: +x, -x, +y, -y, +z, -z
  Eigen::Matrix3d R_cube_world = Eigen::Matrix3d::Identity();
  double intensity = 1;
};

/// The axes of a face's picture: towards the face, its right edge and its lower edge.
struct FaceAxes {
  Eigen::Vector3d forward, right, down;
};

const std::array<FaceAxes, 6>& face_axes() {
  static const std::array<FaceAxes, 6> kAxes = {{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                                 {{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                                 {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                                 {{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}},
                                                 {{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
                                                 {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}}}};
  return kAxes;
}

/// Returns the light of the texel that a direction in the cube's axes meets.
Eigen::Vector3d light_from(const CubeMap& cube, const Eigen::Vector3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const std::size_t face = 2 * static_cast<std::size_t>(axis) + (direction[axis] < 0 ? 1 : 0);
  const FaceAxes& axes = face_axes().at(face);
  const cv::Mat_<cv::Vec4b>& image = cube.faces.at(face);
  const double scale = 0.5 / direction.dot(axes.forward);
  const auto texel = [&](const Eigen::Vector3d& towards) {
    const double place = (0.5 + scale * direction.dot(towards)) * image.rows;
    return std::clamp(static_cast<int>(place), 0, image.rows - 1);
  };
  const cv::Vec4b& code = image(texel(axes.down), texel(axes.right));
  constexpr double kOpaque = 255;
  const double over = code[3] == 0 ? 0 : kOpaque / code[3];
  return over * Eigen::Vector3d(decode_srgb_8bit(code[0]), decode_srgb_8bit(code[1]),
                                decode_srgb_8bit(code[2]));
}

/// The places, kSamples to a pixel along each axis, at which an equirectangular image is sampled.
class SampleGrid {
 public:
  explicit SampleGrid(int rows) : rows_(rows) {
    for (int i = 0; i < 2 * rows * kSamples; ++i) {
      const double longitude = std::numbers::pi * ((i + 0.5) / (rows * kSamples) - 1);
      longitudes_.emplace_back(std::sin(longitude), std::cos(longitude));
    }
  }

  /// Returns the mean light of a pixel over its solid angle.
  Eigen::Vector3d mean_light(const CubeMap& cube, int v, int u) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0;
    for (int i = v * kSamples; i < (v + 1) * kSamples; ++i) {
      const double colatitude = std::numbers::pi * (i + 0.5) / (rows_ * kSamples);
      const double level = std::sin(colatitude);
      const double height = std::cos(colatitude);
      for (int k = u * kSamples; k < (u + 1) * kSamples; ++k) {
        const Eigen::Vector2d& longitude = longitudes_[static_cast<std::size_t>(k)];
        const Eigen::Vector3d direction(level * longitude.x(), height, -level * longitude.y());
        sum += level * light_from(cube, cube.R_cube_world * direction);
      }
      weights += level * kSamples;
    }
    return sum / weights;
  }

 private:
  int rows_;
  std::vector<Eigen::Vector2d> longitudes_;  ///< sine and cosine
};

Environment equirectangular(const CubeMap& cube) {
  const int rows = std::min(2 * cube.faces[0].rows, kMostRows);
  const SampleGrid grid(rows);
  Environment environment;
  environment.radiance.create(rows, 2 * rows);
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < 2 * rows; ++u) {
      const Eigen::Vector3d light = cube.intensity * grid.mean_light(cube, v, u);
      environment.radiance(v, u) = cv::Vec3d(light.x(), light.y(), light.z());
    }
  }
  return environment;
}

/// Throws vo::Error for a texel whose light is its colour over zero.
void require_divisors(const cv::Mat_<cv::Vec4b>& image, const std::string& place) {
  const bool all = std::all_of(image.begin(), image.end(), [](const cv::Vec4b& texel) {
    return texel[3] > 0 || std::max({texel[0], texel[1], texel[2]}) == 0;
  });
  require(all, place,
          ": has a texel that is not black with an alpha of 0, expected light (RGBD), "
          "which is the colour over alpha");
}

cv::Mat_<cv::Vec4b> read_face(const GltfModel& model, int index) {
  const std::string place = model.image_place(index);
  if (model.missing_images.contains(index)) {
    fail_for_missing_images(model);
  }
  cv::Mat_<cv::Vec4b> image = decode_image(read_encoded_image(model, index), place);
  require(image.rows == image.cols && image.rows <= kMostFacePixels, place, ": is ", image.cols,
          " x ", image.rows, " px, expected the square face of a cube map of at most ",
          kMostFacePixels, " px a side");
  require_divisors(image, place);
  return image;
}

CubeMap read_cube_map(const GltfModel& model, const tinygltf::Value& light) {
  CubeMap cube;
  const tinygltf::Value& largest = light.Get("specularImages").Get(0);
  for (int i = 0; i < static_cast<int>(cube.faces.size()); ++i) {
    const int index = largest.Get(i).GetNumberAsInt();
    cv::Mat_<cv::Vec4b>& face = cube.faces.at(static_cast<std::size_t>(i));
    face = read_face(model, index);
    require(face.size() == cube.faces[0].size(), model.image_place(index), ": is ", face.cols,
            " px wide, expected ", cube.faces[0].cols, " as the first face of its cube map");
  }
  if (light.Has("rotation")) {
    const tinygltf::Value& q = light.Get("rotation");
    const auto component = [&](int i) { return q.Get(i).GetNumberAsDouble(); };
    cube.R_cube_world = Eigen::Quaterniond(component(3), component(0), component(1), component(2))
                            .normalized()
                            .toRotationMatrix()
                            .transpose();
  }
  if (light.Has("intensity")) {
    cube.intensity = light.Get("intensity").GetNumberAsDouble();
  }
  return cube;
}

}  // namespace

Environment read_image_based_light(const GltfModel& model, std::optional<int> scene,
                                   const GltfOptions& options, Notes& notes) {
  if (!scene || !options.environment.empty()) {
    return {};
  }
  const tinygltf::ExtensionMap& extensions =
      model.content.scenes[static_cast<std::size_t>(*scene)].extensions;
  const auto reference = extensions.find(kImageBasedLightExtension);
  if (reference == extensions.end()) {
    return {};
  }
  if (options.needed == NeededTextures::surfaces) {
    add_note(notes,
             vo::concat("the light from all sides of the file (", kImageBasedLightExtension,
                        ") is left out; the ray tracer draws it in the modes direct and path"));
  }
  if (options.needed != NeededTextures::all) {
    return {};
  }
  const tinygltf::Value& lights =
      model.content.extensions.at(kImageBasedLightExtension).Get("lights");
  return equirectangular(
      read_cube_map(model, lights.Get(reference->second.Get("light").GetNumberAsInt())));
}

}  // namespace synth
