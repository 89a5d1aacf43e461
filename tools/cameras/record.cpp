#include "tools/cameras/record.h"

#include <atomic>
#include <exception>
#include <future>
#include <optional>
#include <vector>

#include <tbb/concurrent_queue.h>

#include "vo/core/error.h"
#include "vo/dataset/colour_sequence.h"
#include "vo/dataset/sequence.h"
#include "vo/frames/depth_timestamp.h"
#include "vo/output_folders/output_folder.h"

namespace tools {
namespace {

constexpr std::size_t kMostWaiting = 300;  // frames of 640x480 px: 0.6 GB

/// Encodes and writes frames in a thread of its own.
class FrameWriter {
 public:
  FrameWriter(const LiveCamera& camera, const vo::OutputFolder& folder)
      : camera_(camera), folder_(folder) {
    waiting_.set_capacity(kMostWaiting);
    written_ = std::async(std::launch::async, [this] { write_all(); });
  }
  ~FrameWriter() {
    if (written_.valid()) {
      waiting_.push(std::nullopt);
    }
  }
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  FrameWriter(FrameWriter&&) = delete;
  FrameWriter& operator=(FrameWriter&&) = delete;

  /// Takes a frame; throws what writing an earlier one has thrown.
  void put(const vo::RgbdFrame& frame) {
    if (has_failed_) {
      finish();
    }
    waiting_.push(frame);
  }

  /// Waits until all frames are written; throws what writing one of them has thrown.
  void finish() {
    waiting_.push(std::nullopt);
    written_.get();
  }

 private:
  /// Writes what it is given until there is no more; what follows a failure is taken and dropped,
  /// so that nobody waits for room.
  void write_all() {
    std::optional<vo::RgbdFrame> frame;
    std::exception_ptr failure;
    for (std::size_t index = 0; waiting_.pop(frame), frame; ++index) {
      if (failure) {
        continue;
      }
      try {
        folder_.write(camera_.has_depth ? vo::encode_frame({camera_.camera}, index, *frame)
                                        : vo::encode_colour_frame(index, *frame));
      } catch (...) {
        failure = std::current_exception();
        has_failed_ = true;
      }
    }
    if (failure) {
      std::rethrow_exception(failure);
    }
  }

  const LiveCamera& camera_;
  const vo::OutputFolder& folder_;
  tbb::concurrent_bounded_queue<std::optional<vo::RgbdFrame>> waiting_;
  std::atomic<bool> has_failed_ = false;
  std::future<void> written_;
};

}  // namespace

RecordOutcome record(const LiveCamera& camera, const RecordJob& job, const vo::OutputPolicy& policy,
                     const RecordObserver& observer) {
  vo::OutputFolder folder(job.out, policy, {});
  std::vector<double> timestamps;
  std::vector<double> depth_stamps;
  FrameWriter writer(camera, folder);
  while (job.frames == 0 || timestamps.size() < job.frames) {
    const std::optional<vo::RgbdFrame> frame = camera.next(observer.is_stopped);
    if (!frame) {
      break;
    }
    writer.put(*frame);
    timestamps.push_back(frame->timestamp);
    depth_stamps.push_back(vo::depth_timestamp(*frame));
    observer.on_frame(timestamps.size());
  }
  writer.finish();
  vo::require(!timestamps.empty(), camera.device, ": has given no frame before it was stopped");
  folder.write(camera.has_depth ? vo::encode_image_lists({camera.camera}, timestamps, depth_stamps)
                                : vo::encode_colour_lists(camera.camera, timestamps));
  folder.commit();
  return {timestamps.size(), camera.missed(), timestamps.back() - timestamps.front()};
}

}  // namespace tools
