#pragma once

#include <filesystem>

#include "tools/processes/file_lock.h"
#include "vo/dataset/sequence.h"

namespace tools {

/// A copy of what a tracker may know of a sequence in the layout of the TUM benchmark: images,
/// camera, IMU and, where the content asks for it, depth. It has neither ground truth nor exact
/// channels nor the recipe of the sequence, and is read-only. Where the file system can, files
/// share their blocks with the original until they are written (FICLONE); none is a link to it.
class StagedSequence {
 public:
  /// Makes the copy at `folder`, which must not exist. `waiting` is called after each file. Throws
  /// vo::Error when a file cannot be copied, of kind temporary where the disk is full.
  StagedSequence(const std::filesystem::path& sequence, vo::SequenceContent content,
                 const std::filesystem::path& folder, const WaitObserver& waiting);

  ~StagedSequence();  ///< removes the copy
  StagedSequence(const StagedSequence&) = delete;
  StagedSequence& operator=(const StagedSequence&) = delete;
  StagedSequence(StagedSequence&&) = delete;
  StagedSequence& operator=(StagedSequence&&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace tools
