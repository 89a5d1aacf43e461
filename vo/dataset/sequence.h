#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/image.h"
#include "vo/files/output.h"
#include "vo/frames/sequence_frames.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/trajectory.h"
#include "vo/recordings/sequence_topics.h"

namespace vo {

/// File of a sequence in TUM's layout that names the axis of its world that points up, `up = "z"`,
/// where that is known: this project's addition.
inline constexpr const char* kWorldFile = "world.toml";

/// An RGB-D sequence on disk, the one source of frames of everything that tracks. The layout is
/// that of the TUM RGB-D benchmark:
///     rgb/*.png (8 bit; JPEG, PGM or PPM, too)  depth/*.png (16 bit)  rgb.txt  depth.txt
///     groundtruth.txt  camera.toml
/// The lists hold `timestamp path` a line, seconds, in increasing time. groundtruth.txt and
/// camera.toml may be absent. A folder of another SequenceFormat, or a recording, is read as
/// `known_format` recognises it.
class SequenceReader {
 public:
  /// `camera` takes precedence over the folder's camera.toml; throws Error if there is neither.
  /// Colour and depth are paired by nearest stamp, greedily by smallest difference, each image
  /// once. `topics` are for recordings.
  explicit SequenceReader(const std::filesystem::path& folder,
                          std::optional<RgbdCamera> camera = std::nullopt,
                          double max_time_difference = 0.02,
                          SequenceContent content = SequenceContent::colour_and_depth,
                          const SequenceTopics& topics = {});

  const RgbdCamera& camera() const { return camera_; }
  const Trajectory& ground_truth() const { return ground_truth_; }  ///< empty when there is none
  /// Returns sentences on what in the folder was not as its format has it.
  const std::vector<std::string>& notes() const { return notes_; }
  std::size_t size() const { return entries_.size(); }
  double timestamp(std::size_t index) const { return entries_[index].timestamp; }
  std::vector<double> timestamps() const;

  /// Returns the file of a frame's colour image; empty for a format other than TUM's.
  std::filesystem::path image_file(std::size_t index) const;

  /// Reads a frame; throws Error naming an image that cannot be read or has not the camera's size.
  RgbdFrame read(std::size_t index) const;

 private:
  void read_lists(double max_time_difference, SequenceContent content);
  void adopt(SequenceSource source);

  struct Entry {
    double timestamp;
    std::string image;       ///< file in the folder, as the list names it
    std::string depth;       ///< file in the folder, empty where only colour is read
    double depth_delay = 0;  ///< s, as in RgbdFrame
  };

  std::filesystem::path folder_;
  RgbdCamera camera_;
  Trajectory ground_truth_;
  std::vector<std::string> notes_;
  std::vector<Entry> entries_;
  std::function<RgbdFrame(std::size_t index)> read_;  ///< of a format other than TUM's
};

/// Reads the frames of a sequence in order, each decoded in a second thread while the one before
/// it is being worked on.
class FrameStream {
 public:
  explicit FrameStream(const SequenceReader& reader);

  std::optional<RgbdFrame> next();  ///< the next frame; empty after the last one

 private:
  void read_ahead();

  const SequenceReader& reader_;
  std::size_t next_index_ = 0;
  std::future<RgbdFrame> ahead_;
};

/// Format of the float depth that is written besides the 16-bit PNG, which rounds to 1 /
/// depth_units_per_m and cannot hold more than 65534 units.
enum class FloatDepth { none, npy };

/// Camera and depth options of a sequence that is written in the TUM layout.
struct SequenceLayout {
  RgbdCameraModel camera;
  FloatDepth float_depth = FloatDepth::none;
  double depth_delay = 0;  ///< s, from the stamp of a colour image to that of its depth
};

/// Returns the number of a frame as names of files have it: `000012`.
std::string frame_number(std::size_t index);

/// Returns the path of a frame's file within the sequence: `depth/000012.png`.
std::string frame_file(const std::string& folder, std::size_t index, const std::string& extension);

/// Returns the paths of a frame's files: rgb/000000.png, depth/000000.png, on request
/// depth_float/000000.npy (metres, float32).
std::vector<std::string> frame_files(const SequenceLayout& layout, std::size_t index);

/// Encodes a frame as the files that `frame_files` names.
std::vector<NamedBytes> encode_frame(const SequenceLayout& layout, std::size_t index,
                                     const RgbdFrame& frame);

/// Encodes the lists of the images and camera.toml for frames whose images and depth have these
/// stamps, s. The layout's `depth_delay` does not enter.
std::vector<NamedBytes> encode_image_lists(const SequenceLayout& layout,
                                           const std::vector<double>& timestamps,
                                           const std::vector<double>& depth_stamps);

/// Encodes what `encode_image_lists` does and groundtruth.txt for frames 0 to truth.size() - 1,
/// whose depth has the layout's `depth_delay`.
std::vector<NamedBytes> encode_lists(const SequenceLayout& layout, const Trajectory& truth);

}  // namespace vo
