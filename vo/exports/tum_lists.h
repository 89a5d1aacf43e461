#pragma once

#include <vector>

#include "vo/dataset/sequence.h"
#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// Whether the frames of a sequence have depth.
enum class DepthImages { absent, present };

/// Returns the layout that holds a sequence, float depth included if it has some.
SequenceLayout tum_layout(const SequenceSource& source);

/// Encodes a TUM folder's lists, which have a line for each stamp, and its poses and IMU readings,
/// which have stamps of their own.
std::vector<NamedBytes> encode_tum_lists(const SequenceSource& source, DepthImages depth);

}  // namespace vo
