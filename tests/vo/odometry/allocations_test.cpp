#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "tests/support/image_allocations.h"
#include "tests/support/plane_frames.h"
#include "vo/odometry/rgbd_odometry.h"

#ifndef __SANITIZE_ADDRESS__  // whose own operators keep account of what is allocated how

namespace {

/// The number of allocations of the whole program.
std::atomic<std::size_t>& allocations() {
  static std::atomic<std::size_t> count{0};
  return count;
}

void* counted(void* memory) {
  ++allocations();
  return memory != nullptr ? memory : throw std::bad_alloc();
}

}  // namespace

// Not inlined, or g++ takes each malloc and free within them for a mismatch of new and free.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  return counted(std::malloc(bytes));
}

[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit));
}

// Clang's sanitizer has an operator of its own for what is not defined here.
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  ++allocations();
  return std::malloc(bytes);
}

[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace {

using support::small_camera;
using support::sway;

/// Returns whether a vector of this many elements that doubles its memory does so for one more.
bool is_full(std::size_t elements) {
  return (elements & (elements - 1)) == 0;
}

/// A keyframe holds what was allocated for its frame, so the frame after it needs new memory. The
/// trajectory grows by a pose a frame, in memory that doubles.
TEST(RgbdOdometry, AllocatesNothingButForKeyframes) {
  constexpr int kWarmUp = 40;  // frames: the sway's period
  vo::RgbdOdometry odometry(small_camera(), vo::preset_options(vo::TrackerPreset::best_measured));
  int steady = 0;
  bool was_keyframe = true;
  for (int i = 0; i < 2 * kWarmUp; ++i) {
    const vo::RgbdFrame frame = support::plane_frame(small_camera(), sway(i % kWarmUp), i);
    const bool grows = is_full(odometry.trajectory().size());
    const support::ImageAllocations images;
    const std::size_t before = allocations();
    const vo::TrackingResult result = odometry.track(frame);
    const std::size_t made = allocations() - before;
    ASSERT_EQ(result.status != vo::TrackingStatus::lost, true);
    if (i >= kWarmUp && !result.is_keyframe && !was_keyframe && !grows) {
      EXPECT_EQ(made, 0U) << "frame " << i;
      EXPECT_EQ(images.bytes(), 0U) << "frame " << i;
      ++steady;
    }
    was_keyframe = result.is_keyframe;
  }
  EXPECT_GT(steady, 20);
}

}  // namespace

#endif  // __SANITIZE_ADDRESS__
