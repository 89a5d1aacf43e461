#include <optional>
#include <utility>

#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/frame_images.h"
#include "vo/dataset/sequence.h"
#include "vo/dataset/sequence_source.h"
#include "vo/files/input.h"
#include "vo/frames/depth_units.h"
#include "vo/geometry/associate.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

struct ImageList {
  std::vector<double> timestamps;
  std::vector<std::string> names;  ///< files in the sequence's folder
};

ImageList read_image_list(const fs::path& folder, const char* name) {
  const fs::path path = folder / name;
  ImageList list;
  const TextFile file(path);
  list.timestamps.reserve(file.line_count());
  list.names.reserve(file.line_count());
  file.for_each_line([&](const TextLine& line) {
    require(line.fields.size() == 2, line.place(), ": expected `timestamp path`, got ",
            line.fields.size(), " values");
    const double timestamp = parse_timestamp(line, 0);
    require(list.timestamps.empty() || timestamp > list.timestamps.back(), line.place(),
            ": expected a stamp after the one before it, got ", line.fields[0]);
    list.timestamps.push_back(timestamp);
    list.names.emplace_back(line.fields[1]);
    path_in(folder, list.names.back(), line.place());
  });
  require(!list.timestamps.empty(), path.string(), ": lists no images");
  return list;
}

RgbdCamera camera_of(const fs::path& folder, const std::optional<RgbdCamera>& given) {
  if (given) {
    return camera_for_folder(folder, *given);
  }
  const fs::path path = folder / "camera.toml";
  require(fs::exists(path), folder.string(),
          ": has no camera.toml; name the camera with --camera PRESET or FILE.toml");
  return read_camera(path);
}

}  // namespace

SequenceReader::SequenceReader(const fs::path& folder, std::optional<RgbdCamera> camera,
                               double max_time_difference, SequenceContent content,
                               const SequenceTopics& topics)
    : folder_(folder) {
  const std::optional<SequenceFormat> known = known_format(folder);
  require(known || fs::is_directory(folder), folder.string(),
          fs::exists(folder)
              ? kNoSequenceFile
              : ": there is no such folder, expected a sequence (rgb.txt, depth.txt and their "
                "images)");
  const SequenceFormat format = known.value_or(SequenceFormat::tum);
  if (format != SequenceFormat::tum || !topics.are_free()) {
    adopt(open_sequence(folder, format, camera, {topics, max_time_difference, content}));
    require(content == SequenceContent::colour || !read(0).depth.empty(), folder.string(),
            ": its frames have no depth, expected some or --mode mono");
    return;
  }
  camera_ = camera_of(folder, camera);
  read_lists(max_time_difference, content);
  if (fs::exists(folder / "groundtruth.txt")) {
    ground_truth_ = read_truth(folder / "groundtruth.txt", TrajectoryFormat::tum, notes_);
  }
}

void SequenceReader::read_lists(double max_time_difference, SequenceContent content) {
  constexpr double kMostPairs = 0.95;  // share of the images; recorders miss some
  ImageList images = read_image_list(folder_, "rgb.txt");
  entries_.reserve(images.names.size());
  if (content == SequenceContent::colour) {
    for (std::size_t i = 0; i < images.names.size(); ++i) {
      entries_.push_back({images.timestamps[i], std::move(images.names[i]), {}});
    }
  } else {
    const char* list =
        content == SequenceContent::colour_and_depth ? "depth.txt" : "depth_float.txt";
    require(fs::exists(folder_ / list), folder_.string(), ": has no ", list,
            ", expected one or --mode mono");
    ImageList depths = read_image_list(folder_, list);
    for (const auto& [i, j] :
         associate(images.timestamps, depths.timestamps, max_time_difference)) {
      entries_.push_back({images.timestamps[i], std::move(images.names[i]),
                          std::move(depths.names[j]), depths.timestamps[j] - images.timestamps[i]});
    }
    require(!entries_.empty(), folder_.string(), ": no colour and depth image lie within ",
            max_time_difference, " s of each other");
    if (static_cast<double>(entries_.size()) <
        kMostPairs * static_cast<double>(images.names.size())) {
      notes_.push_back(concat(images.names.size() - entries_.size(), " of ", images.names.size(),
                              " colour images have no depth image within ", max_time_difference,
                              " s and are left out"));
    }
  }
}

void SequenceReader::adopt(SequenceSource source) {
  camera_ = source.camera;
  ground_truth_ = std::move(source.truth);
  notes_ = std::move(source.notes);
  for (const double timestamp : source.timestamps) {
    entries_.push_back({timestamp, {}, {}});
  }
  require(!entries_.empty(), folder_.string(), ": holds no frames, expected one or more");
  read_ = std::move(source.read);
}

std::vector<double> SequenceReader::timestamps() const {
  std::vector<double> timestamps;
  for (const Entry& entry : entries_) {
    timestamps.push_back(entry.timestamp);
  }
  return timestamps;
}

fs::path SequenceReader::image_file(std::size_t index) const {
  const Entry& entry = entries_.at(index);
  return entry.image.empty() ? fs::path() : folder_ / entry.image;
}

RgbdFrame SequenceReader::read(std::size_t index) const {
  const Entry& entry = entries_.at(index);
  if (read_) {
    return read_(index);
  }
  RgbdFrame frame;
  frame.timestamp = entry.timestamp;
  const fs::path image = folder_ / entry.image;
  frame.image = read_frame_image(image, camera_.pinhole);
  if (!entry.depth.empty()) {
    const fs::path depth = folder_ / entry.depth;
    frame.depth_delay = entry.depth_delay;
    frame.depth = depth.extension() == ".npy" ? read_depth_npy(depth, camera_.pinhole)
                                              : read_depth_png(depth, camera_);
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
