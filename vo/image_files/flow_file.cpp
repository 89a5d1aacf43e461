#include "vo/image_files/flow_file.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/new_image.h"

namespace vo {
namespace {

constexpr std::string_view kFlowMagic = "PIEH";  // 202021.25 as a float
constexpr std::size_t kHeaderBytes = 12;         // magic number, width and height

}  // namespace

std::string encode_flow(const cv::Mat_<cv::Vec2f>& flow) {
  std::string bytes(kFlowMagic);
  for (const std::int32_t size : {flow.cols, flow.rows}) {
    std::array<char, sizeof(size)> text{};
    std::memcpy(text.data(), &size, sizeof(size));
    bytes.append(text.data(), text.size());
  }
  for (int v = 0; v < flow.rows; ++v) {
    bytes.append(flow.ptr<char>(v), static_cast<std::size_t>(flow.cols) * sizeof(cv::Vec2f));
  }
  return bytes;
}

cv::Mat_<cv::Vec2f> read_flow(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  std::array<std::int32_t, 2> size{};
  require(bytes.size() > kHeaderBytes && bytes.starts_with(kFlowMagic), path.string(),
          ": expected a .flo file of optical flow");
  std::memcpy(size.data(), bytes.data() + kFlowMagic.size(), sizeof(size));
  const auto [cols, rows] = size;
  require(cols > 0 && rows > 0, path.string(), ": expected a size in px, got ", cols, "x", rows);
  const std::size_t pixels =
      static_cast<std::size_t>(cols) * static_cast<std::size_t>(rows) * sizeof(cv::Vec2f);
  require(bytes.size() == kHeaderBytes + pixels, path.string(), ": expected ",
          kHeaderBytes + pixels, " bytes for ", cols, "x", rows, " px, got ", bytes.size());
  cv::Mat_<cv::Vec2f> flow = new_image({cols, rows}, CV_32FC2, path);
  std::memcpy(flow.data, bytes.data() + kHeaderBytes, pixels);
  return flow;
}

}  // namespace vo
