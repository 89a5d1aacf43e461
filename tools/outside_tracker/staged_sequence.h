#pragma once

#include <filesystem>

#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"

namespace tools {

/// Copies what a tracker may know of a sequence in the layout of the TUM benchmark to `folder`,
/// which must not exist: images, camera, IMU and, where the content asks for it, depth. The copy
/// has neither ground truth nor exact channels nor the recipe of the sequence, and is read-only.
/// Where the file system can, files share their blocks with the original until they are written
/// (FICLONE); none is a link to it. `waiting` is called after each image. Throws vo::Error when a
/// file cannot be copied, of kind temporary where the disk is full.
void stage_sequence(const std::filesystem::path& sequence, vo::SequenceContent content,
                    const std::filesystem::path& folder, const vo::WaitObserver& waiting);

}  // namespace tools
