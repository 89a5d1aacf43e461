#include "vo/exports/transforms_json.h"

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/sequence.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"

namespace vo {
namespace {

/// Returns the rows of T_world_camera for a camera with y up and z backwards.
std::string format_opengl_matrix(const SE3& T_world_camera) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() =
      T_world_camera.rotation_matrix() * Eigen::DiagonalMatrix<double, 3>(1, -1, -1);
  matrix.topRightCorner<3, 1>() = T_world_camera.translation();
  std::string text = "[";
  for (int row = 0; row < 4; ++row) {
    text += row == 0 ? "[" : ", [";
    for (int column = 0; column < 4; ++column) {
      text += (column == 0 ? "" : ", ") + format_real(matrix(row, column));
    }
    text += "]";
  }
  return text + "]";
}

/// Returns the model and the coefficients of a lens as members.
std::string format_nerfstudio_lens(const Distortion& lens) {
  const auto member = [](const char* name, double value) {
    return concat("  \"", name, "\": ", format_real(value), ",\n");
  };
  if (lens.model == DistortionModel::kannala_brandt) {
    return "  \"camera_model\": \"OPENCV_FISHEYE\",\n" + member("k1", lens.k1) +
           member("k2", lens.k2) + member("k3", lens.k3) + member("k4", lens.k4);
  }
  return "  \"camera_model\": \"OPENCV\",\n" + member("k1", lens.k1) + member("k2", lens.k2) +
         member("p1", lens.p1) + member("p2", lens.p2) +
         (lens.k3 == 0 ? "" : member("k3", lens.k3));
}

}  // namespace

std::vector<NamedBytes> TransformsJson::encode_frame(std::size_t index, const RgbdFrame& frame) {
  const std::string image = frame_file("images", index, "png");
  std::vector<NamedBytes> files = {{image, encode_png(frame.image)}};
  frames_ += concat(frames_.empty() ? "" : ",\n", "    {\n      \"file_path\": \"", image, "\",\n");
  if (!frame.depth.empty()) {
    has_depth_ = true;
    const std::string depth = frame_file("depths", index, source_.has_float_depth ? "npy" : "png");
    files.push_back({depth, source_.has_float_depth
                                ? encode_npy(DepthImage(frame.depth * kTransformsDepthUnits))
                                : encode_png(to_depth_units(frame.depth, kTransformsDepthUnits))});
    frames_ += concat("      \"depth_file_path\": \"", depth, "\",\n");
  }
  frames_ += concat("      \"timestamp\": ", format_real(frame.timestamp),
                    ",\n      \"transform_matrix\": ",
                    format_opengl_matrix(*pose_at(source_.truth, frame.timestamp)), "\n    }");
  return files;
}

std::vector<NamedBytes> TransformsJson::encode_lists() const {
  const PinholeCamera& camera = source_.camera.pinhole;
  std::string text = concat(
      "{\n  \"w\": ", camera.width, ",\n  \"h\": ", camera.height,
      ",\n  \"fl_x\": ", format_real(camera.fx), ",\n  \"fl_y\": ", format_real(camera.fy),
      ",\n  \"cx\": ", format_real(camera.cx + 0.5), ",\n  \"cy\": ", format_real(camera.cy + 0.5),
      ",\n", format_nerfstudio_lens(camera.distortion));
  if (has_depth_) {
    text +=
        concat("  \"depth_unit_scale_factor\": ", format_real(1 / kTransformsDepthUnits), ",\n");
  }
  return {{"transforms.json", text + "  \"frames\": [\n" + frames_ + "\n  ]\n}\n"}};
}

}  // namespace vo
