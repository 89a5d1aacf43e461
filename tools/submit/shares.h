#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace tools {

/// Returns the shares that a text in the syntax of Slurm's --array names, `1,3-5` (`array_text`),
/// sorted, each once; blanks around it are left out. Throws vo::Error where it is something else.
std::vector<std::size_t> parse_shares(std::string_view text);

/// Returns all shares of `count`: 1 to count.
std::vector<std::size_t> all_shares(std::size_t count);

/// Shares that are one job array. Slurm has no task whose index is MaxArraySize or more, so a later
/// array starts anew from 1 and each of its tasks adds the offset.
struct ArrayChunk {
  std::size_t offset = 0;
  std::vector<std::size_t> indices;  ///< of the tasks, sorted; index + offset is the share

  std::vector<std::size_t> shares() const;
};

/// Splits shares, ascending numbers from 1, into arrays whose indices are below `max_array_size`,
/// at least 2, and which have at most a thousand tasks, whose logs lie in one folder.
std::vector<ArrayChunk> chunk_shares(const std::vector<std::size_t>& shares,
                                     std::size_t max_array_size);

}  // namespace tools
