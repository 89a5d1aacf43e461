#include "tools/studies/alterations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::size_t kFrozenFrames = 60;
constexpr std::size_t kStaleFrames = 10;

/// Returns the camera whose images are those of the given one turned by 90 degrees clockwise.
vo::PinholeCamera turned(const vo::PinholeCamera& camera) {
  vo::PinholeCamera result{.width = camera.height,
                           .height = camera.width,
                           .fx = camera.fy,
                           .fy = camera.fx,
                           .cx = camera.height - 1 - camera.cy,
                           .cy = camera.cx,
                           .distortion = camera.distortion};
  result.distortion.p1 = camera.distortion.p2;
  result.distortion.p2 = -camera.distortion.p1;
  return result;
}

/// Turns a clip by 90 degrees clockwise: what was up is to the right, x' = -y and y' = x.
void turn(Clip& clip) {
  Eigen::Matrix3d R_camera_turned;
  R_camera_turned << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  const vo::SE3 T_camera_turned(Eigen::Quaterniond(R_camera_turned), Eigen::Vector3d::Zero());
  clip.camera = turned(clip.camera);
  for (vo::StampedPose& pose : clip.truth) {
    pose.T_world_camera = pose.T_world_camera * T_camera_turned;
  }
  for (vo::RgbdFrame& frame : clip.frames) {
    cv::Mat image;
    cv::Mat depth;
    cv::rotate(frame.image, image, cv::ROTATE_90_CLOCKWISE);
    cv::rotate(frame.depth, depth, cv::ROTATE_90_CLOCKWISE);
    frame.image = image;
    frame.depth = depth;
  }
}

void turn(Clip& clip, int quarters) {
  for (int i = 0; i < quarters; ++i) {
    turn(clip);
  }
}

/// Plays a clip backwards between the same first and last stamp.
void reverse(Clip& clip) {
  const double sum = clip.frames.front().timestamp + clip.frames.back().timestamp;
  for (vo::RgbdFrame& frame : clip.frames) {
    frame.timestamp = sum - frame.timestamp;
    frame.depth_delay = -frame.depth_delay;
  }
  for (vo::StampedPose& pose : clip.truth) {
    pose.timestamp = sum - pose.timestamp;
  }
  std::reverse(clip.frames.begin(), clip.frames.end());
  std::reverse(clip.truth.begin(), clip.truth.end());
}

void keep_every(Clip& clip, std::size_t step) {
  std::vector<vo::RgbdFrame> kept;
  for (std::size_t i = 0; i < clip.frames.size(); i += step) {
    kept.push_back(clip.frames[i]);
  }
  clip.frames = std::move(kept);
}

/// Returns the nearest depth of each two by two pixels, 0 where none was measured.
vo::DepthImage halved(const vo::DepthImage& depth) {
  vo::DepthImage result(depth.rows / 2, depth.cols / 2);
  for (int v = 0; v < result.rows; ++v) {
    for (int u = 0; u < result.cols; ++u) {
      float nearest = 0;
      for (const float z : {depth(2 * v, 2 * u), depth(2 * v, 2 * u + 1), depth(2 * v + 1, 2 * u),
                            depth(2 * v + 1, 2 * u + 1)}) {
        nearest = vo::has_depth(z) && (nearest == 0 || z < nearest) ? z : nearest;
      }
      result(v, u) = nearest;
    }
  }
  return result;
}

void halve(Clip& clip) {
  clip.camera = clip.camera.halved();
  for (vo::RgbdFrame& frame : clip.frames) {
    cv::Mat image;
    cv::resize(frame.image, image, {clip.camera.width, clip.camera.height}, 0, 0, cv::INTER_AREA);
    frame.image = image;
    frame.depth = halved(frame.depth);
  }
}

/// Dims images to 70 % and back, every 7 frames once, as lamps do beside a camera's frame rate.
void flicker(Clip& clip) {
  constexpr double kPeriod = 7;  // frames
  for (std::size_t i = 0; i < clip.frames.size(); ++i) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(i) / kPeriod;
    cv::Mat image;
    clip.frames[i].image.convertTo(image, -1, 0.85 + 0.15 * std::cos(phase));
    clip.frames[i].image = image;
  }
}

/// Repeats a frame from the middle of the clip under the stamps of those that follow.
void freeze(Clip& clip) {
  const std::size_t first = clip.frames.size() / 2;
  const std::size_t end = std::min(first + kFrozenFrames, clip.frames.size());
  for (std::size_t i = first + 1; i < end; ++i) {
    clip.frames[i].image = clip.frames[first].image;
    clip.frames[i].depth = clip.frames[first].depth;
  }
}

/// Leaves the lower third of image and depth as in the first frame.
void stick_part(Clip& clip) {
  const vo::RgbdFrame first = clip.frames.front();
  const int top = first.image.rows - first.image.rows / 3;
  for (vo::RgbdFrame& frame : clip.frames) {
    frame.image = frame.image.clone();
    frame.depth = frame.depth.clone();
    first.image.rowRange(top, first.image.rows).copyTo(frame.image.rowRange(top, frame.image.rows));
    first.depth.rowRange(top, first.depth.rows).copyTo(frame.depth.rowRange(top, frame.depth.rows));
  }
}

/// Blackens the left half of the image, not of the depth.
void blacken_half(Clip& clip) {
  for (vo::RgbdFrame& frame : clip.frames) {
    frame.image = frame.image.clone();
    frame.image.colRange(0, frame.image.cols / 2).setTo(0);
  }
}

/// Slides a rectangle of `share` of the view back and forth before the camera, 0.6 m away. What it
/// shows is the middle of the clip's last frame; it is as high as the view times the share's root.
void slide_patch(Clip& clip, double share) {
  constexpr float kDistance = 0.6F;  // m
  constexpr double kPeriod = 100;    // frames
  const cv::Mat& shown = clip.frames.back().image;
  const int width = static_cast<int>(std::sqrt(share) * shown.cols);
  const int height = static_cast<int>(std::sqrt(share) * shown.rows);
  const int top = (shown.rows - height) / 2;
  const cv::Mat patch = shown(cv::Rect((shown.cols - width) / 2, top, width, height)).clone();
  for (std::size_t i = 0; i < clip.frames.size(); ++i) {
    vo::RgbdFrame& frame = clip.frames[i];
    const double phase = 2 * std::numbers::pi * static_cast<double>(i) / kPeriod;
    const int left =
        static_cast<int>(std::lround((shown.cols - width) * (0.5 + 0.5 * std::sin(phase))));
    const cv::Rect place(left, top, width, height);
    frame.image = frame.image.clone();
    frame.depth = frame.depth.clone();
    patch.copyTo(frame.image(place));
    frame.depth(place).setTo(kDistance);
  }
}

void mirror_depth(Clip& clip) {
  for (vo::RgbdFrame& frame : clip.frames) {
    cv::Mat mirrored;
    cv::flip(frame.depth, mirrored, 1);
    frame.depth = mirrored;
  }
}

void divide_depth(Clip& clip) {
  constexpr double kDivisor = 5;
  for (vo::RgbdFrame& frame : clip.frames) {
    frame.depth = vo::DepthImage(frame.depth / kDivisor);
  }
}

/// Gives each frame the depth of ten frames before.
void delay_depth(Clip& clip) {
  for (std::size_t i = clip.frames.size(); i-- > kStaleFrames;) {
    clip.frames[i].depth = clip.frames[i - kStaleFrames].depth;
  }
}

/// Bends depth by up to 6 % in upright stripes that wander, as the light of a second camera does.
void stripe_depth(Clip& clip) {
  constexpr double kMost = 0.06;   // share of the depth
  constexpr double kStripes = 16;  // in the view's width
  constexpr double kPeriod = 20;   // frames
  for (std::size_t i = 0; i < clip.frames.size(); ++i) {
    vo::DepthImage depth = clip.frames[i].depth.clone();
    for (int u = 0; u < depth.cols; ++u) {
      const double turns = kStripes * u / depth.cols + static_cast<double>(i) / kPeriod;
      depth.col(u) *= 1 + kMost * std::sin(2 * std::numbers::pi * turns);
    }
    clip.frames[i].depth = depth;
  }
}

/// Draws a dark mesh over the images, twelve wires to a row, as a fence before a camera whose depth
/// is that of what lies behind.
void fence_in(Clip& clip) {
  constexpr int kWires = 12;
  constexpr int kGrey = 20;
  for (vo::RgbdFrame& frame : clip.frames) {
    frame.image = frame.image.clone();
    const int spacing = std::max(frame.image.cols / kWires, 1);
    const int width = std::max(frame.image.cols / 100, 1);
    for (int at = spacing / 2; at + width < frame.image.cols; at += spacing) {
      frame.image.colRange(at, at + width).setTo(kGrey);
    }
    for (int at = spacing / 2; at + width < frame.image.rows; at += spacing) {
      frame.image.rowRange(at, at + width).setTo(kGrey);
    }
  }
}

}  // namespace

std::span<const Alteration> alterations() {
  static constexpr std::array kAll{
      Alteration{"none", "as recorded", [](Clip&) {}},
      Alteration{"reversed", "played backwards", reverse},
      Alteration{"turned_90", "image and depth turned by 90 deg",
                 [](Clip& clip) { turn(clip, 1); }},
      Alteration{"turned_180", "image and depth turned by 180 deg",
                 [](Clip& clip) { turn(clip, 2); }},
      Alteration{"turned_270", "image and depth turned by 270 deg",
                 [](Clip& clip) { turn(clip, 3); }},
      Alteration{"every_third", "every third frame", [](Clip& clip) { keep_every(clip, 3); }},
      Alteration{"half_size", "half the width and height", halve},
      Alteration{"flicker", "brightness 70 to 100 %, period 7 frames", flicker},
      Alteration{"frozen", "image and depth frozen for 60 frames", freeze},
      Alteration{"stuck_part", "lower third stuck at the first frame", stick_part},
      Alteration{"half_black", "left half of the image black", blacken_half},
      Alteration{"patch_25", "a patch 0.6 m away slides over 25 %",
                 [](Clip& clip) { slide_patch(clip, 0.25); }},
      Alteration{"patch_40", "a patch 0.6 m away slides over 40 %",
                 [](Clip& clip) { slide_patch(clip, 0.40); }},
      Alteration{"patch_70", "a patch 0.6 m away slides over 70 %",
                 [](Clip& clip) { slide_patch(clip, 0.70); }},
      Alteration{"depth_mirrored", "depth mirrored", mirror_depth},
      Alteration{"depth_fifth", "depth divided by five", divide_depth},
      Alteration{"depth_stale", "depth of 10 frames before", delay_depth},
      Alteration{"depth_striped", "depth bent by 6 % in stripes", stripe_depth},
      Alteration{"fence", "a fence before the image", fence_in},
  };
  return kAll;
}

Clip altered(const Clip& clip, std::string_view name) {
  for (const Alteration& alteration : alterations()) {
    if (alteration.name == name) {
      Clip result = clip;
      alteration.apply(result);
      return result;
    }
  }
  vo::fail("alteration '", name, "': unknown");
}

}  // namespace tools
