#pragma once

#include "vo/dataset/sequence_source.h"
#include "vo/exports/convert_sequence.h"

namespace vo {

/// Returns the sequence of a job as its target can hold it. Throws Error where it cannot.
SequenceSource fit_to_target(const ConvertJob& job, SequenceSource source);

}  // namespace vo
