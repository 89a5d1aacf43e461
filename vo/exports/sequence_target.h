#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/exports/tum_lists.h"
#include "vo/files/output.h"

namespace vo {

/// The formats that a sequence is written in: folders, but for MCAP and videos, which are files.
enum class WrittenSequence {
  tum,
  euroc,
  icl_nuim,
  icl_tum,
  tartanair,
  kitti,
  colmap,
  transforms_json,
  mcap,
  video,
};

constexpr auto enum_names(WrittenSequence) {
  return std::array{std::pair{WrittenSequence::tum, "tum"},
                    std::pair{WrittenSequence::euroc, "euroc"},
                    std::pair{WrittenSequence::icl_nuim, "icl-nuim"},
                    std::pair{WrittenSequence::icl_tum, "icl-tum"},
                    std::pair{WrittenSequence::tartanair, "tartanair"},
                    std::pair{WrittenSequence::kitti, "kitti"},
                    std::pair{WrittenSequence::colmap, "colmap"},
                    std::pair{WrittenSequence::transforms_json, "transforms-json"},
                    std::pair{WrittenSequence::mcap, "mcap"},
                    std::pair{WrittenSequence::video, "video"}};
}

/// Whether a format can do without something of the frames.
enum class Need {
  optional,
  all_or_none,  ///< of every frame or of none
  required,     ///< of every frame
};

/// The lenses that a format has parameters for.
enum class LensModels {
  none,  ///< a perfect one alone
  four,  ///< Brown and Conrady's of k1, k2, p1, p2, and Kannala and Brandt's
  five,  ///< Brown and Conrady's of k1, k2, p1, p2, k3, and Kannala and Brandt's
  all,
};

/// What a format can hold of a sequence beside its images, and what it cannot do without.
struct TargetTraits {
  Need depth = Need::optional;
  Need poses = Need::optional;  ///< frames without one are left out where it is not optional
  LensModels lenses = LensModels::none;
  bool holds_y_up = false;  ///< a camera with y up, of which fy is negative
  bool holds_depth = true;  ///< as images
  bool holds_float_depth = false;
  bool holds_depth_stamps = false;
  bool holds_stamps = true;  ///< of the frames
  bool holds_poses = true;   ///< and the camera
  bool holds_imu = false;
  bool holds_sensor = false;      ///< the shutter's read-out and the depth camera's noise
  WorldUp up = WorldUp::unknown;  ///< of the format's worlds; unknown: any
  bool may_choose_world = false;  ///< whether another than `up` will do
};

TargetTraits traits_of(WrittenSequence format);

/// Returns the units of the depth images that a format holds, 1/m; 0 where it holds floats or none.
double written_depth_units(WrittenSequence format, const SequenceSource& source);

/// Returns whether a format has parameters for a lens.
bool holds_lens(WrittenSequence format, const Distortion& lens);

/// Returns what of a sequence a format cannot hold, each as the words of a list.
std::vector<std::string> list_dropped(WrittenSequence format, const SequenceSource& source,
                                      DepthImages depth);

/// The files that a sequence becomes in a format.
struct SequenceTarget {
  /// Called for each frame in order, with its index; the pose is the source's at its stamp.
  std::function<std::vector<NamedBytes>(std::size_t index, const RgbdFrame& frame)> encode_frame;

  /// Returns the files that belong to no single frame; called after the last one.
  std::function<std::vector<NamedBytes>()> encode_lists;
};

/// Returns the target of a format that is a folder; the source must outlive it.
SequenceTarget make_target(WrittenSequence format, const SequenceSource& source);

}  // namespace vo
