#pragma once

#include <filesystem>
#include <memory>

#include "vo/files/output.h"
#include "vo/odometry/track_sequence.h"

namespace tools {

/// Writes the panel of every n-th frame into a folder that appears when all are there.
class PanelWriter {
 public:
  /// `every` 0 writes none and makes no folder.
  PanelWriter(const std::filesystem::path& folder, int every, vo::ExistingOutput existing);

  vo::FrameObserver observer();  ///< refers to this writer
  void commit();

 private:
  void write(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
             const vo::Tracker& tracker, const vo::TrackingResult& result) const;

  int every_;
  int frame_ = 0;
  std::unique_ptr<vo::OutputFolder> output_;
};

}  // namespace tools
