#include "tools/bench/frames.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "tools/processes/scratch_folder.h"
#include "vo/files/output.h"

namespace tools {

Frames load_frames(const vo::SequenceReader& sequence, std::size_t count,
                   const vo::Progress& progress) {
  Frames result{sequence.camera().pinhole, {}, sequence.ground_truth()};
  const std::size_t total = std::min(count, sequence.size());
  for (std::size_t i = 0; i < total; ++i) {
    result.frames.push_back(sequence.read(i));
    progress(i + 1, total);
  }
  return result;
}

Frames render_frames(synth::RenderJob job, std::size_t count, const vo::Progress& rendering,
                     const vo::Progress& loading) {
  vo::Trajectory& truth = job.recipe.truth;
  truth.resize(std::min(truth.size(), count));
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path() / "sequence";
  synth::render_sequence(job, folder, vo::ExistingOutput::keep, rendering);
  return load_frames(vo::SequenceReader(folder), count, loading);
}

vo::PinholeCamera resized(const vo::PinholeCamera& camera, cv::Size size) {
  const double scale_u = static_cast<double>(size.width) / camera.width;
  const double scale_v = static_cast<double>(size.height) / camera.height;
  vo::PinholeCamera result = camera;
  result.width = size.width;
  result.height = size.height;
  result.fx = scale_u * camera.fx;
  result.fy = scale_v * camera.fy;
  result.cx = scale_u * (camera.cx + 0.5) - 0.5;
  result.cy = scale_v * (camera.cy + 0.5) - 0.5;
  return result;
}

vo::RgbdFrame resized(const vo::RgbdFrame& frame, cv::Size size) {
  const bool shrinks = size.area() < frame.image.size().area();
  vo::RgbdFrame result{frame.timestamp, {}, {}, frame.depth_delay};
  cv::resize(frame.image, result.image, size, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  // INTER_NEAREST takes the top-left pixel of those that a pixel covers, not the central one.
  cv::resize(frame.depth, result.depth, size, 0, 0, cv::INTER_NEAREST_EXACT);
  return result;
}

}  // namespace tools
