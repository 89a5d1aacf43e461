#pragma once

#include <cstddef>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/image.h"
#include "vo/files/output.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace vo {

/// What of a sequence is read.
enum class SequenceContent {
  colour_and_depth,
  colour,  ///< depth.txt and its images are not touched; frames have no depth
};

/// An RGB-D sequence on disk, in the layout of the TUM RGB-D benchmark:
///     rgb/*.png (8 bit)  depth/*.png (16 bit)  rgb.txt  depth.txt  groundtruth.txt  camera.toml
/// The lists hold `timestamp path` a line, seconds, in increasing time. groundtruth.txt and
/// camera.toml may be absent.
class SequenceReader {
 public:
  /// `camera` takes precedence over the folder's camera.toml; one of them must be there. Colour and
  /// depth are paired by nearest stamp, greedily by smallest difference, each image once.
  explicit SequenceReader(const std::filesystem::path& folder,
                          std::optional<RgbdCamera> camera = std::nullopt,
                          double max_time_difference = 0.02,
                          SequenceContent content = SequenceContent::colour_and_depth);

  const RgbdCamera& camera() const { return camera_; }
  const Trajectory& ground_truth() const { return ground_truth_; }  ///< empty when there is none
  std::size_t size() const { return entries_.size(); }
  double timestamp(std::size_t index) const { return entries_[index].timestamp; }
  const std::filesystem::path& image_file(std::size_t index) const { return entries_[index].image; }

  /// Throws Error naming the image that cannot be read or has another size than the camera.
  RgbdFrame read(std::size_t index) const;

 private:
  struct Entry {
    double timestamp;
    std::filesystem::path image;
    std::filesystem::path depth;  ///< empty where only colour is read
  };

  RgbdCamera camera_;
  Trajectory ground_truth_;
  std::vector<Entry> entries_;
};

/// The frames of a sequence in order, each decoded in a second thread while the one before it is
/// being worked on.
class FrameStream {
 public:
  explicit FrameStream(const SequenceReader& reader);

  std::optional<RgbdFrame> next();  ///< nothing after the last frame

 private:
  void read_ahead();

  const SequenceReader& reader_;
  std::size_t next_index_ = 0;
  std::future<RgbdFrame> ahead_;
};

/// How depth is written beside the 16-bit PNG, which rounds to 1 / depth_units_per_m and cannot
/// hold more than 65534 units.
enum class FloatDepth { none, npy };

/// What a writer of sequences must know.
struct SequenceLayout {
  RgbdCamera camera;
  FloatDepth float_depth = FloatDepth::none;
  double depth_delay = 0;  ///< s, the stamps of depth after those of colour
};

/// `depth/000012.png`: where everything about a frame lies.
std::string frame_file(const std::string& folder, std::size_t index, const std::string& extension);

/// The names of a frame's files in the same layout: rgb/000000.png, depth/000000.png, on request
/// depth_float/000000.npy (metres, float32).
std::vector<std::string> frame_files(const SequenceLayout& layout, std::size_t index);

/// These files.
std::vector<NamedBytes> encode_frame(const SequenceLayout& layout, std::size_t index,
                                     const RgbdFrame& frame);

/// The lists, groundtruth.txt and camera.toml for frames 0 to truth.size() - 1.
std::vector<NamedBytes> encode_lists(const SequenceLayout& layout, const Trajectory& truth);

/// Writes sequences. Frames may be written in any order and from several threads.
class SequenceWriter {
 public:
  /// Makes the sub-folders of `folder`, which must exist.
  SequenceWriter(std::filesystem::path folder, const RgbdCamera& camera,
                 FloatDepth float_depth = FloatDepth::none);

  void write_frame(std::size_t index, const RgbdFrame& frame) const;

  void finish(const Trajectory& truth) const;  ///< `encode_lists`

 private:
  std::filesystem::path folder_;
  SequenceLayout layout_;
};

/// `0.033333`: how every list of a sequence writes a stamp.
std::string format_timestamp(double timestamp);

}  // namespace vo
