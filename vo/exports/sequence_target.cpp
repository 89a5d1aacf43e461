#include "vo/exports/sequence_target.h"

#include <memory>

#include "vo/core/error.h"
#include "vo/dataset/colour_sequence.h"
#include "vo/dataset/euroc.h"
#include "vo/dataset/icl_nuim.h"
#include "vo/dataset/sequence.h"
#include "vo/dataset/tartanair.h"
#include "vo/exports/colmap.h"
#include "vo/exports/kitti.h"
#include "vo/exports/transforms_json.h"
#include "vo/exports/tum_lists.h"
#include "vo/frames/depth_timestamp.h"
#include "vo/videos/write_video.h"

namespace vo {
namespace {

/// Returns the target of a writer with `encode_frame` and `encode_lists`.
template <typename Writer>
SequenceTarget target_of(const SequenceSource& source) {
  const auto writer = std::make_shared<Writer>(source);
  return {[writer](std::size_t index, const RgbdFrame& frame) {
            return writer->encode_frame(index, frame);
          },
          [writer] { return writer->encode_lists(); }};
}

SequenceTarget tum_target(const SequenceSource& source) {
  const auto depth_stamps = std::make_shared<std::vector<double>>();
  return {[&source, depth_stamps](std::size_t index, const RgbdFrame& frame) {
            if (frame.depth.empty()) {
              return encode_colour_frame(index, frame);
            }
            depth_stamps->push_back(depth_timestamp(frame));
            return encode_frame(tum_layout(source), index, frame);
          },
          [&source, depth_stamps] { return encode_tum_lists(source, *depth_stamps); }};
}

SequenceTarget euroc_target(const SequenceSource& source) {
  const auto depth_stamps = std::make_shared<std::vector<double>>();
  return {[&source, depth_stamps](std::size_t, const RgbdFrame& frame) {
            if (!frame.depth.empty()) {
              depth_stamps->push_back(depth_timestamp(frame));
            }
            return encode_euroc_frame(source.camera, frame);
          },
          [&source, depth_stamps] { return encode_euroc_lists(source, *depth_stamps); }};
}

SequenceTarget icl_nuim_target(const SequenceSource& source) {
  return {[&source](std::size_t index, const RgbdFrame& frame) {
            return encode_icl_nuim_frame(source.camera, index, frame,
                                         *pose_at(source.truth, frame.timestamp));
          },
          [&source] { return encode_icl_nuim_lists(source); }};
}

SequenceTarget icl_tum_target(const SequenceSource& source) {
  return {[&source](std::size_t index, const RgbdFrame& frame) {
            return encode_icl_tum_frame(source.camera, index, frame);
          },
          [&source] { return encode_icl_tum_lists(source); }};
}

SequenceTarget tartanair_target(const SequenceSource& source) {
  return {encode_tartanair_frame, [&source] { return encode_tartanair_lists(source); }};
}

}  // namespace

TargetTraits traits_of(WrittenSequence format) {
  switch (format) {
    case WrittenSequence::tum:
      return {.lenses = LensModels::all,
              .holds_y_up = true,
              .holds_float_depth = true,
              .holds_depth_stamps = true,
              .holds_imu = true,
              .holds_sensor = true,
              .may_choose_world = true};
    case WrittenSequence::euroc:
      return {.lenses = LensModels::four,
              .holds_y_up = true,
              .holds_depth_stamps = true,
              .holds_imu = true,
              .up = WorldUp::z,
              .may_choose_world = true};
    case WrittenSequence::icl_nuim:
      return {.depth = Need::required,
              .poses = Need::required,
              .holds_float_depth = true,
              .holds_stamps = false,
              .holds_sensor = true,
              .up = WorldUp::y};
    case WrittenSequence::icl_tum:
      return {
          .depth = Need::required, .holds_stamps = false, .holds_sensor = true, .up = WorldUp::y};
    case WrittenSequence::tartanair:
      return {.poses = Need::all_or_none,
              .holds_float_depth = true,
              .holds_stamps = false,
              .holds_sensor = true,
              .up = WorldUp::minus_y};
    case WrittenSequence::kitti:
      return {.poses = Need::all_or_none, .holds_depth = false};
    case WrittenSequence::colmap:
      return {.poses = Need::required,
              .lenses = LensModels::all,
              .holds_depth = false,
              .may_choose_world = true};
    case WrittenSequence::transforms_json:
      return {.poses = Need::required,
              .lenses = LensModels::five,
              .holds_float_depth = true,
              .up = WorldUp::z,
              .may_choose_world = true};
    case WrittenSequence::mcap:
      return {.lenses = LensModels::all,
              .holds_y_up = true,
              .holds_float_depth = true,
              .holds_depth_stamps = true};
    case WrittenSequence::video:
      return {.lenses = LensModels::all,
              .holds_y_up = true,
              .holds_depth = false,
              .holds_poses = false};
  }
  return {};
}

double written_depth_units(WrittenSequence format, const SequenceSource& source) {
  switch (format) {
    case WrittenSequence::tum:
    case WrittenSequence::euroc:
    case WrittenSequence::icl_tum:
      return source.camera.depth_units_per_m;
    case WrittenSequence::transforms_json:
      return source.has_float_depth ? 0 : kTransformsDepthUnits;
    case WrittenSequence::icl_nuim:
    case WrittenSequence::tartanair:
    case WrittenSequence::kitti:
    case WrittenSequence::colmap:
    case WrittenSequence::mcap:
    case WrittenSequence::video:
      return 0;
  }
  return 0;
}

bool holds_lens(WrittenSequence format, const Distortion& lens) {
  const bool is_fisheye = lens.model == DistortionModel::kannala_brandt;
  switch (traits_of(format).lenses) {
    case LensModels::none:
      return lens.is_zero();
    case LensModels::four:
      return is_fisheye || (lens.k3 == 0 && !lens.is_rational());
    case LensModels::five:
      return !lens.is_rational();
    case LensModels::all:
      return true;
  }
  return false;
}

std::vector<std::string> list_dropped(WrittenSequence format, const SequenceSource& source,
                                      DepthImages depth) {
  const TargetTraits traits = traits_of(format);
  std::vector<std::string> dropped;
  if (!traits.holds_depth && depth != DepthImages::absent) {
    dropped.emplace_back(format == WrittenSequence::colmap ? "depth but that of points3D.txt"
                                                           : "depth");
  }
  if (traits.holds_depth && !traits.holds_float_depth && source.has_float_depth) {
    dropped.emplace_back("what depth has beyond 16 bit");
  }
  if (!traits.holds_stamps ||
      (format == WrittenSequence::video && !video_holds(source.timestamps))) {
    dropped.emplace_back("the frames' stamps");
  } else if (traits.holds_depth && !traits.holds_depth_stamps && depth == DepthImages::delayed) {
    dropped.emplace_back("the stamps of depth");
  }
  if (!traits.holds_poses) {
    dropped.emplace_back("the camera");
    if (!source.truth.empty()) {
      dropped.push_back(concat("the ", source.truth.size(), " poses"));
    }
  }
  if (!traits.holds_imu && !source.imu.samples.empty()) {
    dropped.push_back(concat("the IMU's ", source.imu.samples.size(), " samples"));
  }
  if (!traits.holds_sensor && source.camera.readout.is_rolling()) {
    dropped.emplace_back("the rolling shutter's read-out time");
  }
  if (!traits.holds_sensor && source.camera.depth_noise.is_known()) {
    dropped.emplace_back("the depth camera's noise");
  }
  return dropped;
}

SequenceTarget make_target(WrittenSequence format, const SequenceSource& source) {
  switch (format) {
    case WrittenSequence::tum:
      return tum_target(source);
    case WrittenSequence::euroc:
      return euroc_target(source);
    case WrittenSequence::icl_nuim:
      return icl_nuim_target(source);
    case WrittenSequence::icl_tum:
      return icl_tum_target(source);
    case WrittenSequence::tartanair:
      return tartanair_target(source);
    case WrittenSequence::kitti:
      return target_of<KittiOdometry>(source);
    case WrittenSequence::colmap:
      return target_of<ColmapModel>(source);
    case WrittenSequence::transforms_json:
      return target_of<TransformsJson>(source);
    case WrittenSequence::mcap:
    case WrittenSequence::video:
      break;
  }
  return {};
}

}  // namespace vo
