#pragma once

#include <filesystem>
#include <memory>

#include "vo/files/output.h"
#include "vo/output_folders/output_folder.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

/// Writes the panel of every n-th frame into a folder that appears when committed.
class PanelWriter {
 public:
  /// Begins the folder, having waited for others that make it; with `every` 0 nothing is written
  /// and no folder made.
  PanelWriter(const std::filesystem::path& folder, int every, const vo::OutputPolicy& policy,
              const vo::WaitObserver& waiting);

  vo::FrameObserver observer();  ///< callback that writes panels; refers to this writer
  void commit();

 private:
  void write(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
             const vo::Tracker& tracker, const vo::TrackingResult& result) const;

  int every_;
  int frame_ = 0;
  std::unique_ptr<vo::OutputFolder> output_;
};

}  // namespace tools
