#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "vo/core/progress.h"
#include "vo/frames/sequence_frames.h"
#include "vo/videos/write_video.h"

namespace support {

/// The size of the images of `noise_images`, px.
inline constexpr int kNoiseWidth = 96;
inline constexpr int kNoiseHeight = 64;

inline vo::RgbdCamera noise_camera() {
  return {vo::PinholeCamera::from_horizontal_fov(kNoiseWidth, kNoiseHeight, 60)};
}

/// Returns images of noise, which no lossy codec keeps, each another.
inline std::vector<cv::Mat> noise_images(int count, int channels) {
  std::vector<cv::Mat> images;
  cv::RNG random(7);
  for (int i = 0; i < count; ++i) {
    cv::Mat image(kNoiseHeight, kNoiseWidth, CV_8UC(channels));
    random.fill(image, cv::RNG::UNIFORM, 0, 256);
    images.push_back(image);
  }
  return images;
}

/// Returns a sequence of images at an even rate, from 0 s on, that is in memory.
inline vo::SequenceSource sequence_of(const std::vector<cv::Mat>& images, double rate_hz) {
  vo::SequenceSource source;
  for (std::size_t i = 0; i < images.size(); ++i) {
    source.timestamps.push_back(static_cast<double>(i) / rate_hz);
  }
  source.read = [images, stamps = source.timestamps](std::size_t index) {
    return vo::RgbdFrame{stamps.at(index), images.at(index), {}};
  };
  return source;
}

inline void write_video_of(const std::filesystem::path& path, const std::vector<cv::Mat>& images,
                           double rate_hz) {
  vo::write_video(path, sequence_of(images, rate_hz), {}, [](std::size_t, std::size_t) {});
}

/// Returns the number of 32 bits, little endian as RIFF has it, at a place in bytes.
inline std::uint32_t riff_number(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) {
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
  }
  return number;
}

}  // namespace support
