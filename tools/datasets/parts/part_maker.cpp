#include "tools/datasets/parts/part_maker.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "synth/rig/rig_files.h"
#include "tools/datasets/part_folder.h"
#include "tools/datasets/part_record.h"
#include "tools/datasets/parts/archive_names.h"
#include "tools/datasets/parts/frame_rows.h"
#include "tools/datasets/sha256.h"
#include "tools/pictures/webp.h"
#include "vo/archives/tar.h"
#include "vo/core/error.h"
#include "vo/core/process_name.h"
#include "vo/core/processor_time.h"
#include "vo/exports/convert_sequence.h"
#include "vo/files/input.h"
#include "vo/image_files/png.h"
#include "vo/output_folders/file_records.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr double kSecondsPerMs = 1e-3;

/// A frame on its way through the pipeline that makes a part.
struct FrameOnItsWay {
  std::size_t camera = 0;
  std::size_t index = 0;
  std::vector<vo::NamedBytes> files;  ///< as they are written; empty where they have been
  std::vector<MadeFile> made;
  double depth_coverage = 0;  ///< share of pixels with depth
};

MadeFile made_file(const vo::NamedBytes& file) {
  return {file.name, file.bytes.size(), sha256(file.bytes)};
}

/// Returns the record of a file that has been written below `folder`.
MadeFile made_file(const fs::path& folder, const std::string& name) {
  return {name, fs::file_size(folder / name), sha256_of_file(folder / name)};
}

double coverage_of(const vo::NamedBytes& depth_png) {
  const cv::Mat depth = vo::decode_png(depth_png.bytes, depth_png.name);
  return static_cast<double>(cv::countNonZero(depth)) / static_cast<double>(depth.total());
}

/// Returns a picture of a colour or grey image, at most 320 pixels wide.
std::string thumbnail_of(const vo::NamedBytes& png) {
  constexpr int kWidth = 320;      // px
  constexpr double kQuality = 80;  // of 100
  cv::Mat image = vo::decode_png(png.bytes, png.name);
  if (image.channels() == 1) {
    cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
  }
  if (image.cols > kWidth) {
    cv::resize(image, image, {kWidth, kWidth * image.rows / image.cols}, 0, 0, cv::INTER_AREA);
  }
  return encode_webp(image, kQuality);
}

/// Writes the frames of one part.
class PartWriter {
 public:
  PartWriter(const DatasetSpec& spec, const SequenceJob& job, const DatasetPart& part,
             PartFolder& folder)
      : sequence_(spec.sequences[part.sequence]),
        job_(job),
        part_(part),
        folder_(folder),
        archive_(spec.options.tar ? sequence_.name + "/" + part_name(spec, part) + ".tar" : "") {
    const std::string archive = archive_.empty() ? "" : scene_folder(sequence_) + archive_;
    for (std::size_t camera = 0; camera < job.cameras.size(); ++camera) {
      rows_.emplace_back(sequence_, job, camera, part, archive);
    }
  }

  /// Renders all frames: files are written in parallel, an archive in the order of the frames, of
  /// each by all cameras.
  void write_frames(const vo::Progress& progress) {
    const synth::RigFrames frames(job_.cameras);
    const std::size_t cameras = job_.cameras.size();
    const auto tokens = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    std::size_t next = cameras * part_.first;
    const auto number = [&](tbb::flow_control& control) {
      if (next == cameras * part_.end) {
        control.stop();
        return next;
      }
      return next++;
    };
    const auto render = [&](std::size_t frame) {
      return rendered(frames, frame % cameras, frame / cameras);
    };
    const auto collect = [&](const std::shared_ptr<FrameOnItsWay>& frame) {
      take(*frame);
      if (progress) {
        progress(cameras * (frame->index - part_.first) + frame->camera + 1,
                 cameras * part_.frame_count());
      }
    };
    tbb::parallel_pipeline(
        tokens, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, number) &
                    tbb::make_filter<std::size_t, std::shared_ptr<FrameOnItsWay>>(
                        tbb::filter_mode::parallel, render) &
                    tbb::make_filter<std::shared_ptr<FrameOnItsWay>, void>(
                        tbb::filter_mode::serial_in_order, collect));
    close_archive();
  }

  /// Writes the files that belong to no frame, in the part with the first frame.
  void write_lists() {
    if (part_.first > 0) {
      return;
    }
    const std::vector<MadeFile> made = write(job_.files());
    made_.insert(made_.end(), made.begin(), made.end());
  }

  std::vector<MadeFile> made() const { return made_; }
  std::string csv() const { return csv_; }

 private:
  std::shared_ptr<FrameOnItsWay> rendered(const synth::RigFrames& frames, std::size_t camera,
                                          std::size_t index) const {
    auto frame = std::make_shared<FrameOnItsWay>();
    frame->camera = camera;
    frame->index = index;
    frame->files = frames.make(camera, index).files;
    frame->depth_coverage = coverage_of(frame->files.at(1));
    if (camera == 0 && index == job_.frame_count() / 2) {
      folder_.write({{kPartPicture, thumbnail_of(frame->files.front())}});
    }
    if (archive_.empty()) {
      if (job_.rig) {
        synth::move_into(job_.camera_name(camera), frame->files);
      }
      frame->made = write(std::exchange(frame->files, {}));
    }
    return frame;
  }

  /// Writes files of the sequence, and returns what was made.
  std::vector<MadeFile> write(std::vector<vo::NamedBytes> files) const {
    synth::move_into(sequence_.name, files);
    std::vector<MadeFile> made;
    for (const vo::NamedBytes& file : files) {
      made.push_back(made_file(file));
    }
    folder_.write(files);
    return made;
  }

  /// Takes the frames in their order.
  void take(const FrameOnItsWay& frame) {
    for (const vo::NamedBytes& file : frame.files) {
      folder_.append(
          archive_,
          vo::tar_entry({archive_name(sequence_.name, job_.camera_name(frame.camera), file.name),
                         file.bytes}));
    }
    made_.insert(made_.end(), frame.made.begin(), frame.made.end());
    csv_ += rows_[frame.camera].row(frame.index, frame.depth_coverage);
  }

  void close_archive() {
    if (archive_.empty()) {
      return;
    }
    folder_.append(archive_, vo::tar_end());
    made_.push_back(made_file(folder_.partial(), archive_));
  }

  const DatasetSequence& sequence_;
  const SequenceJob& job_;
  const DatasetPart& part_;
  PartFolder& folder_;
  std::string archive_;          ///< name of the part's tar; empty = files
  std::vector<FrameRows> rows_;  ///< by camera
  std::vector<MadeFile> made_;
  std::string csv_;
};

/// Returns where a sequence of a format goes, beside its folder.
std::string converted_name(const DatasetSequence& sequence, vo::WrittenSequence format) {
  const std::string name = sequence.name + "." + std::string(vo::to_string(format));
  return format == vo::WrittenSequence::video ? name + ".avi" : name;
}

/// Adds what lies in a part under a name, a file or a folder, to the files that were made.
void add_converted(const fs::path& folder, const std::string& name, std::vector<MadeFile>& made) {
  if (fs::is_regular_file(folder / name)) {
    made.push_back(made_file(folder, name));
    return;
  }
  for (const std::string& file : vo::files_below(folder / name)) {
    made.push_back(made_file(folder, vo::concat(name, "/", file)));
  }
}

}  // namespace

fs::path PartMaker::folder_of(std::size_t part) const {
  return layout_.part(part, part_name(spec_, plan_.parts.at(part)));
}

bool PartMaker::is_there(std::size_t part) const {
  return path_exists(folder_of(part) / kPartRecord);
}

void PartMaker::make(std::size_t index, const vo::Progress& progress) {
  const double start_ms = vo::processor_ms();
  const DatasetPart& part = plan_.parts.at(index);
  const DatasetSequence& sequence = spec_.sequences[part.sequence];
  const SequenceJob& job = jobs_.job(part.sequence);
  vo::require(job.frame_count() == plan_.frames[part.sequence], layout_.plan().string(),
              ": sequences: ", sequence.name, ": got ", plan_.frames[part.sequence],
              " frames, expected ", job.frame_count(), ", as its path has");
  PartFolder folder(folder_of(index));
  PartWriter writer(spec_, job, part, folder);
  writer.write_frames(progress);
  writer.write_lists();
  std::vector<MadeFile> made = writer.made();
  const std::size_t frames = plan_.cameras * part.frame_count();
  const vo::Progress converting = [&](std::size_t /*done*/, std::size_t /*total*/) {
    progress(frames, frames);  // all are rendered; this also ends a run that is interrupted
  };
  for (const vo::WrittenSequence format : spec_.formats()) {
    const std::string name = converted_name(sequence, format);
    vo::convert_sequence(
        {.in = folder.partial() / sequence.name, .out = folder.partial() / name, .to = format},
        {vo::ExistingOutput::keep, vo::Durability::unsynced}, converting);
    add_converted(folder.partial(), name, made);
  }
  folder.write({{kPartFrames, writer.csv()}});
  std::vector<MadeFile> index_files{made_file(folder.partial(), kPartFrames)};
  if (path_exists(folder.partial() / kPartPicture)) {
    index_files.push_back(made_file(folder.partial(), kPartPicture));
  }
  const double processor_s = kSecondsPerMs * (vo::processor_ms() - start_ms);
  folder.write(
      {{kPartRecord, format_part_record({part_name(spec_, part), plan_hash_, vo::host_name(),
                                         processor_s, made, index_files})}});
  folder.commit(durability_);
}

}  // namespace tools
