#pragma once

#include <vector>

#include "vo/dataset/sequence.h"
#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// The depth that the frames of a sequence have: none, some with the images' stamps, or some with
/// stamps of its own.
enum class DepthImages { absent, present, delayed };

/// Returns the layout that holds a sequence, float depth included if it has some.
SequenceLayout tum_layout(const SequenceSource& source);

/// Encodes a TUM folder's lists, which have a line for each stamp, and its poses and IMU readings,
/// which have stamps of their own. `depth_stamps`, s, are those of the frames' depth, none where
/// there is no depth.
std::vector<NamedBytes> encode_tum_lists(const SequenceSource& source,
                                         const std::vector<double>& depth_stamps);

}  // namespace vo
