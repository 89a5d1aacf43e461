#include "tools/pictures/panel_writer.h"

#include <array>
#include <cstdio>

#include "tools/pictures/panels.h"
#include "vo/image_files/png.h"

namespace tools {

PanelWriter::PanelWriter(const std::filesystem::path& folder, int every,
                         const vo::OutputPolicy& policy, const vo::WaitObserver& waiting)
    : every_(every) {
  if (every_ > 0) {
    output_ = std::make_unique<vo::OutputFolder>(folder, policy, waiting);
  }
}

vo::FrameObserver PanelWriter::observer() {
  if (every_ == 0) {
    return {};
  }
  return
      [this](const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
             const vo::Tracker& tracker, const vo::TrackingResult& result, const vo::StageTimes&) {
        if (frame_ % every_ == 0) {
          write(frame, pyramid, tracker, result);
        }
        ++frame_;
      };
}

void PanelWriter::commit() {
  if (output_) {
    output_->commit();
  }
}

void PanelWriter::write(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                        const vo::Tracker& tracker, const vo::TrackingResult& result) const {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%06d.png", frame_);
  output_->write({{name.data(), vo::encode_png(draw_panel(frame, pyramid, tracker, result))}});
}

}  // namespace tools
