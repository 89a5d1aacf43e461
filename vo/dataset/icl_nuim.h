#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// Opens the ICL-NUIM data set (Handa et al., ICRA 2014) as rendered. Its two forms have POV-Ray's
/// camera, y up, in its left-handed world: fy is negative, and `mirrored` converts poses. Frames
/// are 1 / 30 s apart and have no stamps. camera.toml is this project's addition; without it the
/// camera is the preset icl-nuim.
///
/// The files are scene_00_0000.png, .depth (metres from the camera's centre, as text, row by row)
/// and .txt (POV-Ray's vectors). Checked against the authors' compute3Dpositions.m and getcamK.m
/// (ankurhanda/living_room_iclnuim) and a .txt of theirs: pixels / |cam_right| and pixels /
/// |cam_up| are the focal lengths 481.2 and 480, cam_up x cam_dir is along cam_right.
SequenceSource open_icl_nuim(const std::filesystem::path& folder,
                             const std::optional<RgbdCamera>& camera);

/// Opens the "TUM compatible" form of the ICL-NUIM data set: rgb/0.png, depth/0.png (16 bit, 5000
/// per metre, planar), associations.txt (`0 depth/0.png 0 rgb/0.png`) and a trajectory in TUM's
/// format, *.gt.freiburg, whose stamps are frame numbers. The data set's own trajectories lack the
/// first frame, or two.
SequenceSource open_icl_tum(const std::filesystem::path& folder,
                            const std::optional<RgbdCamera>& camera);

/// Converts between this project's frames (camera y down, right-handed world) and the data set's,
/// either way: the camera's y and the world's z change sign.
SE3 mirrored(const SE3& T_world_camera);
RgbdCamera mirrored(const RgbdCamera& camera);

/// Encodes a frame as files; the pose is in this project's frames.
std::vector<NamedBytes> encode_icl_nuim_frame(const RgbdCamera& camera, std::size_t index,
                                              const RgbdFrame& frame, const SE3& T_world_camera);
std::vector<NamedBytes> encode_icl_tum_frame(const RgbdCamera& camera, std::size_t index,
                                             const RgbdFrame& frame);

/// Encodes all files but those of the frames.
std::vector<NamedBytes> encode_icl_nuim_lists(const SequenceSource& source);
std::vector<NamedBytes> encode_icl_tum_lists(const SequenceSource& source);

}  // namespace vo
