#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <opencv2/core.hpp>

namespace support {

/// The bytes that OpenEXR writes.
class ExrBytes : public Imf::OStream {
 public:
  ExrBytes() : Imf::OStream("bytes") {}

  void write(const char* data, int count) override {
    const auto length = static_cast<std::size_t>(count);
    bytes_.resize(std::max(bytes_.size(), at_ + length));
    bytes_.replace(at_, length, data, length);
    at_ += length;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = position; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

inline void write_pixels(Imf::OutputFile& file, int rows) {
  file.writePixels(rows);
}

inline void write_pixels(Imf::TiledOutputFile& file, int /*rows*/) {
  file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

/// Returns the file that OpenEXR's own writer makes of an image, its channels, again and again,
/// under these names.
template <typename File = Imf::OutputFile>
std::string encode_exr(const cv::Mat_<cv::Vec3f>& image, Imf::Header header, Imf::PixelType type,
                       const std::vector<std::string>& names = {"R", "G", "B"}) {
  std::vector<cv::Mat> planes;
  cv::split(image, planes);
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < names.size(); ++i) {
    cv::Mat& plane = planes.at(i % planes.size());
    plane.convertTo(plane, type == Imf::HALF ? CV_16F : CV_32F);
    header.channels().insert(names[i], Imf::Channel(type));
    buffer.insert(names[i], Imf::Slice::Make(type, plane.data, header.dataWindow(),
                                             plane.elemSize(), plane.step[0]));
  }
  ExrBytes stream;
  {
    File file(stream, header);
    file.setFrameBuffer(buffer);
    write_pixels(file, image.rows);
  }
  return stream.bytes();
}

/// Returns the channels R, G and B as OpenEXR's reader in C++ finds them.
inline cv::Mat_<cv::Vec3f> decode_exr(const std::filesystem::path& path) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  const cv::Size size(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
  std::vector<cv::Mat> planes;
  Imf::FrameBuffer buffer;
  for (const char* name : {"R", "G", "B"}) {
    const cv::Mat& plane = planes.emplace_back(size, CV_32F);
    buffer.insert(name,
                  Imf::Slice::Make(Imf::FLOAT, plane.data, window, sizeof(float), plane.step[0]));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  cv::Mat_<cv::Vec3f> image;
  cv::merge(planes, image);
  return image;
}

inline std::string encode_exr(const cv::Mat_<cv::Vec3f>& image, Imf::Compression compression,
                              Imf::PixelType type) {
  Imf::Header header(image.cols, image.rows);
  header.compression() = compression;
  return encode_exr(image, header, type);
}

}  // namespace support
