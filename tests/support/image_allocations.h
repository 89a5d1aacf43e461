#pragma once

#include <cstddef>

#include <opencv2/core.hpp>

namespace support {

/// Counts the bytes of images that are allocated while it lives.
class ImageAllocations : public cv::MatAllocator {
 public:
  ImageAllocations() { cv::Mat::setDefaultAllocator(this); }
  ImageAllocations(const ImageAllocations&) = delete;
  ImageAllocations& operator=(const ImageAllocations&) = delete;
  ~ImageAllocations() override { cv::Mat::setDefaultAllocator(cv::Mat::getStdAllocator()); }

  std::size_t bytes() const { return bytes_; }

  // NOLINTNEXTLINE(readability-function-size)
  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    cv::UMatData* memory =
        cv::Mat::getStdAllocator()->allocate(dims, sizes, type, data, step, flags, usage);
    bytes_ += memory->size;
    return memory;
  }

  bool allocate(cv::UMatData* memory, cv::AccessFlag flags,
                cv::UMatUsageFlags usage) const override {
    return cv::Mat::getStdAllocator()->allocate(memory, flags, usage);
  }

  void deallocate(cv::UMatData* memory) const override {
    cv::Mat::getStdAllocator()->deallocate(memory);
  }

 private:
  mutable std::size_t bytes_ = 0;
};

}  // namespace support
