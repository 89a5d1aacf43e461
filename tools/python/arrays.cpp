#include "tools/python/arrays.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "vo/core/error.h"
#include "vo/frames/depth_units.h"

namespace python {

namespace py = pybind11;

namespace {

/// Memory of images that belongs to Python arrays. An image's last copy gives its array back, on
/// whatever thread that happens.
class ArrayMemory : public cv::MatAllocator {
 public:
  cv::UMatData* adopted(const py::array& array) const {
    auto data = std::make_unique<cv::UMatData>(this);
    data->data = data->origdata = static_cast<uchar*>(const_cast<void*>(array.data()));
    data->size = static_cast<std::size_t>(array.nbytes());
    data->userdata = array.ptr();
    data->refcount = 1;
    array.inc_ref();
    return data.release();
  }

  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    return cv::Mat::getStdAllocator()->allocate(dims, sizes, type, data, step, flags, usage);
  }

  bool allocate(cv::UMatData* data, cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    return cv::Mat::getStdAllocator()->allocate(data, flags, usage);
  }

  void deallocate(cv::UMatData* data) const override {
    const py::gil_scoped_acquire gil;
    py::handle(static_cast<PyObject*>(data->userdata)).dec_ref();
    delete data;
  }
};

const ArrayMemory& array_memory() {
  static const ArrayMemory memory;
  return memory;
}

py::dtype dtype_of(int depth) {
  switch (depth) {
    case CV_8U:
      return py::dtype::of<std::uint8_t>();
    case CV_16U:
      return py::dtype::of<std::uint16_t>();
    case CV_32S:
      return py::dtype::of<std::int32_t>();
    case CV_32F:
      return py::dtype::of<float>();
    default:
      return py::dtype::of<double>();
  }
}

std::string shape_of(const py::array& array) {
  std::string text;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i == 0 ? "" : " x ") + std::to_string(array.shape(i));
  }
  return text + " of " + py::cast<std::string>(array.dtype().attr("name"));
}

}  // namespace

cv::Mat shared_image(const py::array& array, int depth, const std::string& what) {
  const py::dtype wanted = dtype_of(depth);
  const bool is_image = array.ndim() == 2 || (array.ndim() == 3 && array.shape(2) <= CV_CN_MAX);
  vo::require(is_image && array.dtype().is(wanted), what, ": is ", shape_of(array),
              ", expected height x width or height x width x channels of ",
              py::cast<std::string>(wanted.attr("name")));
  const int channels = array.ndim() == 3 ? static_cast<int>(array.shape(2)) : 1;
  const py::ssize_t element = wanted.itemsize();
  vo::require(
      array.strides(1) == channels * element && (array.ndim() == 2 || array.strides(2) == element),
      what, ": its pixels are apart in memory, expected rows without gaps");
  cv::Mat image(static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)),
                CV_MAKETYPE(depth, channels), const_cast<void*>(array.data()),
                static_cast<std::size_t>(array.strides(0)));
  image.u = array_memory().adopted(array);
  image.allocator = const_cast<ArrayMemory*>(&array_memory());
  return image;
}

py::object shared_array(const cv::Mat& image) {
  if (image.empty()) {
    return py::none();
  }
  const auto element = static_cast<py::ssize_t>(image.elemSize1());
  std::vector<py::ssize_t> shape{image.rows, image.cols};
  std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(image.step[0]),
                                   static_cast<py::ssize_t>(image.elemSize())};
  if (image.channels() > 1) {
    shape.push_back(image.channels());
    strides.push_back(element);
  }
  const py::capsule owner(new cv::Mat(image),
                          [](void* owned) { delete static_cast<cv::Mat*>(owned); });
  py::array array(dtype_of(image.depth()), shape, strides, image.data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

vo::RgbdFrame frame_of(double timestamp, const py::array& image,
                       const std::optional<py::array>& depth, const vo::RgbdCamera& camera) {
  vo::require(std::isfinite(timestamp), "timestamp: expected a number of seconds, got ", timestamp);
  vo::RgbdFrame frame{timestamp, shared_image(image, CV_8U, "image"), {}};
  vo::require(frame.image.channels() == 1 || frame.image.channels() == 3, "image: has ",
              frame.image.channels(), " channels, expected grey or blue, green, red");
  if (!depth) {
    return frame;
  }
  if (depth->dtype().is(dtype_of(CV_16U))) {
    frame.depth =
        vo::from_depth_units(shared_image(*depth, CV_16U, "depth"), camera.depth_units_per_m);
  } else {
    const cv::Mat metres = shared_image(*depth, CV_32F, "depth");
    vo::require(metres.channels() == 1, "depth: has ", metres.channels(),
                " channels, expected one");
    frame.depth = metres;
    if (!cv::checkRange(metres)) {
      frame.depth = metres.clone();
      std::replace_if(
          frame.depth.begin(), frame.depth.end(), [](float z) { return !std::isfinite(z); }, 0.0F);
    }
  }
  return frame;
}

Eigen::Matrix4d matrix_of(const vo::SE3& T_a_b) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = T_a_b.rotation_matrix();
  matrix.topRightCorner<3, 1>() = T_a_b.translation();
  return matrix;
}

vo::SE3 motion_of(const Eigen::Matrix4d& matrix) {
  constexpr double kTolerance = 1e-6;
  const Eigen::Matrix3d R = matrix.topLeftCorner<3, 3>();
  const bool is_rotation = (R * R.transpose()).isIdentity(kTolerance) && R.determinant() > 0;
  const bool is_homogeneous = matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), kTolerance);
  vo::require(matrix.allFinite() && is_rotation && is_homogeneous,
              "pose: is no rigid motion, expected [R t; 0 0 0 1] with a rotation R");
  return {Eigen::Quaterniond(R), matrix.topRightCorner<3, 1>()};
}

}  // namespace python
