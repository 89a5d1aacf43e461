#pragma once

#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// Encodes a TUM folder's lists, which have a line for each stamp, and its poses and IMU readings,
/// which have stamps of their own.
std::vector<NamedBytes> encode_tum_lists(const SequenceSource& source);

}  // namespace vo
