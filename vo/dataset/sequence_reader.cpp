#include <optional>
#include <utility>

#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/depth_units.h"
#include "vo/dataset/sequence.h"
#include "vo/dataset/sequence_source.h"
#include "vo/dataset/trajectory_file.h"
#include "vo/files/png.h"
#include "vo/files/text_lines.h"
#include "vo/geometry/associate.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

struct ImageList {
  std::vector<double> timestamps;
  std::vector<fs::path> paths;
};

ImageList read_image_list(const fs::path& folder, const char* name) {
  const fs::path path = folder / name;
  ImageList list;
  for (const TextLine& line : read_text_lines(path)) {
    require(line.fields.size() == 2, line.place, ": expected `timestamp path`, got ",
            line.fields.size(), " values");
    const double timestamp = parse_number(line, 0);
    require(list.timestamps.empty() || timestamp > list.timestamps.back(), line.place,
            ": expected a stamp after the one before it, got ", line.fields[0]);
    list.timestamps.push_back(timestamp);
    list.paths.push_back(folder / line.fields[1]);
  }
  require(!list.timestamps.empty(), path.string(), ": lists no images");
  return list;
}

RgbdCamera camera_of(const fs::path& folder, const std::optional<RgbdCamera>& given) {
  if (given) {
    return *given;
  }
  const fs::path path = folder / "camera.toml";
  require(fs::exists(path), folder.string(),
          ": has no camera.toml; name the camera with --camera PRESET or FILE.toml");
  return read_camera(path);
}

}  // namespace

SequenceReader::SequenceReader(const fs::path& folder, std::optional<RgbdCamera> camera,
                               double max_time_difference, SequenceContent content) {
  require(fs::is_directory(folder), folder.string(),
          ": there is no such folder, expected a sequence (rgb.txt, depth.txt and their images)");
  const SequenceFormat format = known_format(folder).value_or(SequenceFormat::tum);
  if (format != SequenceFormat::tum) {
    adopt(open_sequence(folder, format, camera), folder);
    require(content == SequenceContent::colour || !read(0).depth.empty(), folder.string(),
            ": its frames have no depth, expected some or --mode mono");
    return;
  }
  camera_ = camera_of(folder, camera);
  read_lists(folder, max_time_difference, content);
  if (fs::exists(folder / "groundtruth.txt")) {
    ground_truth_ = read_trajectory(folder / "groundtruth.txt");
  }
}

void SequenceReader::read_lists(const fs::path& folder, double max_time_difference,
                                SequenceContent content) {
  const ImageList images = read_image_list(folder, "rgb.txt");
  if (content == SequenceContent::colour) {
    for (std::size_t i = 0; i < images.paths.size(); ++i) {
      entries_.push_back({images.timestamps[i], images.paths[i], {}});
    }
  } else {
    const ImageList depths = read_image_list(folder, "depth.txt");
    for (const auto& [i, j] :
         associate(images.timestamps, depths.timestamps, max_time_difference)) {
      entries_.push_back({images.timestamps[i], images.paths[i], depths.paths[j]});
    }
    require(!entries_.empty(), folder.string(), ": no colour and depth image lie within ",
            max_time_difference, " s of each other");
  }
}

void SequenceReader::adopt(SequenceSource source, const fs::path& folder) {
  camera_ = source.camera;
  ground_truth_ = std::move(source.truth);
  for (const double timestamp : source.timestamps) {
    entries_.push_back({timestamp, {}, {}});
  }
  require(!entries_.empty(), folder.string(), ": holds no frames, expected one or more");
  read_ = std::move(source.read);
}

std::vector<double> SequenceReader::timestamps() const {
  std::vector<double> timestamps;
  for (const Entry& entry : entries_) {
    timestamps.push_back(entry.timestamp);
  }
  return timestamps;
}

RgbdFrame SequenceReader::read(std::size_t index) const {
  const Entry& entry = entries_.at(index);
  if (read_) {
    return read_(index);
  }
  RgbdFrame frame;
  frame.timestamp = entry.timestamp;
  frame.image = read_png(entry.image);
  require_size(frame.image, camera_.pinhole, entry.image);
  require(frame.image.depth() == CV_8U, entry.image.string(),
          ": expected 8 bits per channel, got 16");
  if (!entry.depth.empty()) {
    frame.depth = read_depth_png(entry.depth, camera_);
  }
  return frame;
}

FrameStream::FrameStream(const SequenceReader& reader) : reader_(reader) {
  read_ahead();
}

std::optional<RgbdFrame> FrameStream::next() {
  if (!ahead_.valid()) {
    return std::nullopt;
  }
  RgbdFrame frame = ahead_.get();
  read_ahead();
  return frame;
}

void FrameStream::read_ahead() {
  if (next_index_ < reader_.size()) {
    ahead_ = std::async(std::launch::async,
                        [&reader = reader_, index = next_index_] { return reader.read(index); });
    ++next_index_;
  }
}

}  // namespace vo
