#pragma once

#include <array>
#include <utility>

#include "vo/edges/edges.h"
#include "vo/geometry/camera.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/align_options.h"
#include "vo/tracking/map_options.h"
#include "vo/tracking/window_options.h"

namespace vo {

/// The pose at which the alignment of a frame starts.
enum class MotionModel {
  stationary,         ///< the last pose
  constant_velocity,  ///< the last pose moved on as between the last two frames
  best,               ///< whichever of the two agrees better with the keyframe
};

constexpr auto enum_names(MotionModel) {
  return std::array{std::pair{MotionModel::stationary, "stationary"},
                    std::pair{MotionModel::constant_velocity, "constant_velocity"},
                    std::pair{MotionModel::best, "best"}};
}

/// The treatment of lens distortion in the warp.
enum class LensModel {
  ignore,      ///< the pinhole part alone, as in the paper
  distortion,  ///< rays are undistorted and projections distorted; images stay as they are
};

constexpr auto enum_names(LensModel) {
  return std::array{std::pair{LensModel::ignore, "ignore"},
                    std::pair{LensModel::distortion, "distortion"}};
}

/// The treatment of a rolling shutter in the warp.
enum class ShutterModel {
  given,  ///< the read-out is `align.readout` along `align.readout_axis`; 0 s is a global shutter
  estimated,  ///< the read-out is found while tracking, from the given one on
};

constexpr auto enum_names(ShutterModel) {
  return std::array{std::pair{ShutterModel::given, "given"},
                    std::pair{ShutterModel::estimated, "estimated"}};
}

/// The conditions under which a frame becomes a keyframe.
struct KeyframeOptions {
  int every = 1;             ///< frames from keyframe to keyframe; 1 is frame to frame, 0 by view
  double max_flow = 0.04;    ///< mean displacement since the last keyframe, image widths
  double min_sharpness = 0;  ///< sharpness relative to the last keyframe; blurred frames wait

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, KeyframeOptions& options) {
  visit("every", options.every, "frames from keyframe to keyframe; 1 is frame to frame, 0 by view");
  visit("max_flow", options.max_flow, "a new one beyond this mean displacement, image widths");
  visit("min_sharpness", options.min_sharpness,
        "not yet where edges are weaker than this share of what they are in the last one");
}

/// The conditions under which an alignment is rejected.
struct LostOptions {
  double min_correlation = 0.5;    ///< correlation of the intensities at visible points
  double min_depth_agreement = 0;  ///< share of the reference's surfaces measured in place
  bool recover = false;            ///< whether other starting points are tried

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, LostOptions& options) {
  visit("min_correlation", options.min_correlation,
        "lost below this correlation of the intensities at the visible points");
  visit("min_depth_agreement", options.min_depth_agreement,
        "lost below this share of the reference's surfaces measured where they would be seen");
  visit("recover", options.recover,
        "whether turned poses and all keyframes are tried before a frame is lost");
}

/// The treatment of a fall-off of brightness towards the corners.
enum class VignetteModel {
  ignore,
  estimated,  ///< found while tracking and removed from every image
};

constexpr auto enum_names(VignetteModel) {
  return std::array{std::pair{VignetteModel::ignore, "ignore"},
                    std::pair{VignetteModel::estimated, "estimated"}};
}

/// The treatment of depth that is measured before or after the image.
enum class DepthTime {
  image,  ///< taken for depth at the image's time
  own,    ///< moved to the image's time by the camera's velocity and the depth's own stamp
};

constexpr auto enum_names(DepthTime) {
  return std::array{std::pair{DepthTime::image, "image"}, std::pair{DepthTime::own, "own"}};
}

struct TrackerOptions {
  PyramidOptions pyramid;
  EdgeOptions edges;
  EdgePointOptions points;
  AlignOptions align;
  KeyframeOptions keyframes;
  MapOptions map;
  WindowOptions window;
  LostOptions lost;
  bool symmetric = false;  ///< whether references are looked up at the current frame's points, too
  MotionModel motion_model = MotionModel::constant_velocity;
  LensModel lens = LensModel::distortion;
  ShutterModel shutter = ShutterModel::given;
  VignetteModel vignette = VignetteModel::ignore;
  DepthTime depth_time = DepthTime::image;
  bool doubt = false;  ///< whether what moves is left out, and poses are doubted

  void validate() const;  ///< throws Error if an option is invalid

  /// Returns these options for a camera: where no option gives them, the depth noise is the
  /// camera's and an estimate of the read-out starts from the camera's.
  TrackerOptions starting_from(const RgbdCamera& camera) const;
};

template <typename Visitor>
void visit_fields(Visitor& visit, TrackerOptions& options) {
  visit("pyramid", options.pyramid, "");
  visit("edges", options.edges, "");
  visit("points", options.points, "");
  visit("align", options.align, "");
  visit("keyframes", options.keyframes, "");
  visit("map", options.map, "");
  visit("window", options.window, "");
  visit("lost", options.lost, "");
  visit("symmetric", options.symmetric,
        "whether references are looked up at the current frame's points, too");
  visit("motion_model", options.motion_model, "where the search for the next pose starts");
  visit("lens", options.lens, "how lens distortion enters the warp");
  visit("shutter", options.shutter, "how a rolling shutter enters the warp");
  visit("vignette", options.vignette, "how a fall-off of brightness towards the corners enters");
  visit("depth_time", options.depth_time, "how depth measured before or after the image enters");
  visit(
      "doubt", options.doubt,
      "whether what moves is left out, and poses are uncertain where images repeat or parts of the "
      "view disagree");
}

}  // namespace vo
