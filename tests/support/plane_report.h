#pragma once

#include "tests/support/plane_frames.h"
#include "tools/report/scenario_report.h"
#include "vo/odometry/rgbd_odometry.h"

namespace support {

/// A report of tracking the textured plane along the sway, `frames` frames of 160x120; from frame
/// `covered_from` on a hand is before the lens.
inline tools::ScenarioReport plane_report(int frames, int covered_from,
                                          const tools::GalleryOptions& gallery = {}) {
  tools::ScenarioReport report;
  report.name = "plane";
  report.why = "a textured plane, closed form";
  report.repeat = {.folder = "/home/user", .command = "edvo run plane.toml --out plane_again"};
  report.camera = vo::PinholeCamera::from_horizontal_fov(160, 120, 60);
  report.gallery = tools::FrameGallery(gallery);
  const vo::FrameObserver observe = report.gallery.observer();
  vo::RgbdOdometry odometry(*report.camera, vo::preset_options(vo::TrackerPreset::paper));
  for (int i = 0; i < frames; ++i) {
    const vo::RgbdFrame frame =
        i < covered_from ? sway_frame(*report.camera, i) : blank_frame(*report.camera, 0, i);
    report.frames.push_back(odometry.track(frame));
    observe(frame, odometry.current(), odometry.tracker(), report.frames.back(),
            odometry.stage_times());
    report.truth.push_back({frame.timestamp, sway(i)});
  }
  report.estimate = odometry.trajectory();
  return report;
}

}  // namespace support
